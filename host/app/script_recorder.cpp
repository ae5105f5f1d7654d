// SPDX-License-Identifier: BSD-3-Clause
#include "host/app/script_recorder.h"

#include "host/file/file_error.h"

namespace cagewright::host {

void ScriptRecorder::start(const std::filesystem::path& path) {
  stop();
  file_.open(path, std::ios::trunc);
  if (!file_) throw FileError(path, {}, "a script cannot be written here");
  const auto write = [this](const nlohmann::json& command) {
    file_ << command.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) << std::endl;
  };
  const Workspace& workspace = editor_.workspace();
  if (workspace.has_scene()) {
    std::filesystem::path scene = workspace.path();
    if (!workspace.has_file() || !workspace.is_saved()) {  // no file holds it: one beside the script does
      scene = path;
      scene += ".glb";
      workspace.save_copy(scene);
    }
    write({{"command", "open"}, {"path", scene.string()}});
    if (workspace.mesh_node() >= 0) write({{"command", "select_mesh"}, {"node", workspace.mesh_node()}});
  }
  // At once, so that a crash leaves what led to it.
  editor_.script().record(write);
}

void ScriptRecorder::stop() {
  editor_.script().record({});
  if (file_.is_open()) file_.close();
}

}  // namespace cagewright::host
