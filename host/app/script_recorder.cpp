// SPDX-License-Identifier: BSD-3-Clause
#include "host/app/script_recorder.h"

#include "host/file/file_error.h"

namespace cagewright::host {

void ScriptRecorder::start(const std::filesystem::path& path) {
  stop();
  file_.open(path, std::ios::trunc);
  if (!file_) throw FileError(path, {}, "a script cannot be written here");
  if (editor_.workspace().has_scene())
    file_ << nlohmann::json{{"command", "open"}, {"path", editor_.workspace().path().string()}}.dump() << std::endl;
  // At once, so that a crash leaves what led to it.
  editor_.script().record([this](const nlohmann::json& command) { file_ << command.dump() << std::endl; });
}

void ScriptRecorder::stop() {
  editor_.script().record({});
  if (file_.is_open()) file_.close();
}

}  // namespace cagewright::host
