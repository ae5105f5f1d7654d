// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_APP_SCRIPT_RECORDER_H
#define CAGEWRIGHT_HOST_APP_SCRIPT_RECORDER_H

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "host/app/editor.h"

namespace cagewright::host {

// Writes every command that is run into a file, a JSON object a line, as `cagewright --command FILE` reads it.
class ScriptRecorder {
 public:
  // `tell_end` gets the sentence of a recording that could not go on; what was recorded until then stays.
  ScriptRecorder(Editor& editor, std::function<void(const std::string& sentence)> tell_end);

  // Begins with opening a copy of the scene as it is now, beside the script: what is saved later may be saved over the
  // scene's own file. What is undone of before, which a replay cannot undo, is recorded as another copy that is opened.
  // Throws FileError where a file cannot be written.
  void start(const std::filesystem::path& path);
  void stop();
  bool is_recording() const { return file_.is_open(); }
  // The scene that is open now came by no command.
  void record_scene();

 private:
  void record(nlohmann::json command);
  bool follow(const std::string& command);  // false: a replay could not
  void write(const nlohmann::json& command);
  void write_scene();  // the commands that open it as it is now
  std::filesystem::path copy_of(std::uint64_t state);
  void attempt(const std::function<void()>& action);

  Editor& editor_;
  std::function<void(const std::string&)> tell_end_;
  std::filesystem::path path_;
  std::ofstream file_;
  // The states of the undo stack that a replay has been in, and in which of them it is.
  std::vector<std::uint64_t> states_;
  std::size_t now_ = 0;
  std::map<std::uint64_t, std::filesystem::path> copies_;  // of this scene, by their state
  int copy_count_ = 0;                                     // of all scenes
};

}  // namespace cagewright::host

#endif
