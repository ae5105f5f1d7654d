// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_APP_SCRIPT_RECORDER_H
#define CAGEWRIGHT_HOST_APP_SCRIPT_RECORDER_H

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <vector>

#include "host/app/editor.h"

namespace cagewright::host {

// Writes every command that is run into a file, a JSON object a line, as `cagewright --command FILE` reads it.
class ScriptRecorder {
 public:
  explicit ScriptRecorder(Editor& editor) : editor_(editor) {}

  // Begins with opening the scene as it is now: its file, or a copy beside the script. What is undone of before, which
  // a replay cannot undo, is recorded as another copy that is opened. Throws FileError where the file cannot be
  // written.
  void start(const std::filesystem::path& path);
  void stop();
  bool is_recording() const { return file_.is_open(); }

 private:
  void record(const nlohmann::json& command);
  void write(const nlohmann::json& command);
  void write_scene();  // the commands that open it as it is now

  Editor& editor_;
  std::filesystem::path path_;
  std::ofstream file_;
  // The states of the undo stack that a replay has been in, and in which of them it is.
  std::vector<std::uint64_t> states_;
  std::size_t now_ = 0;
  int copies_ = 0;  // of the scene, beside the script
};

}  // namespace cagewright::host

#endif
