// SPDX-License-Identifier: BSD-3-Clause
#include "host/app/script_recorder.h"

#include "host/file/file_error.h"

namespace cagewright::host {

void ScriptRecorder::start(const std::filesystem::path& path) {
  stop();
  file_.open(path, std::ios::trunc);
  if (!file_) throw FileError(path, {}, "a script cannot be written here");
  path_ = path;
  copies_ = 0;
  write_scene();
  editor_.script().record([this](const nlohmann::json& command) { record(command); });
}

// At once, so that a crash leaves what led to it.
void ScriptRecorder::write(const nlohmann::json& command) {
  file_ << command.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) << std::endl;
}

void ScriptRecorder::write_scene() {
  const Workspace& workspace = editor_.workspace();
  states_ = {workspace.has_scene() ? workspace.stack().state() : 0};
  now_ = 0;
  if (!workspace.has_scene()) return;
  std::filesystem::path scene = workspace.path();
  if (!workspace.has_file() || !workspace.is_saved()) {  // no file holds it: one beside the script does
    scene = path_;
    if (++copies_ > 1) scene.concat(".").concat(std::to_string(copies_));
    scene += ".glb";
    workspace.save_copy(scene);
  }
  write({{"command", "open"}, {"path", scene.string()}});
  if (workspace.mesh_node() >= 0) write({{"command", "select_mesh"}, {"node", workspace.mesh_node()}});
}

void ScriptRecorder::record(const nlohmann::json& command) {
  const std::string name = command.value("command", "");
  const Workspace& workspace = editor_.workspace();
  const std::uint64_t state = workspace.has_scene() ? workspace.stack().state() : 0;
  if (name == "undo" || name == "redo") {
    const std::size_t next = name == "redo" ? now_ + 1 : now_ - 1;  // before the first: none
    if (next >= states_.size() || states_[next] != state) return write_scene();
    now_ = next;
  } else if (name == "open" || name == "close") {
    states_ = {state};
    now_ = 0;
  } else if (state != states_[now_]) {
    states_.resize(++now_);
    states_.push_back(state);
  }
  write(command);
}

void ScriptRecorder::stop() {
  editor_.script().record({});
  if (file_.is_open()) file_.close();
}

}  // namespace cagewright::host
