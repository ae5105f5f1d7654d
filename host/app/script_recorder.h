// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_APP_SCRIPT_RECORDER_H
#define CAGEWRIGHT_HOST_APP_SCRIPT_RECORDER_H

#include <filesystem>
#include <fstream>

#include "host/app/editor.h"

namespace cagewright::host {

// Writes every command that is run into a file, a JSON object a line, as `cagewright --command FILE` reads it.
class ScriptRecorder {
 public:
  explicit ScriptRecorder(Editor& editor) : editor_(editor) {}

  // Begins with opening the scene as it is now: its file, or a copy beside the script. Throws FileError where the file
  // cannot be written.
  void start(const std::filesystem::path& path);
  void stop();
  bool is_recording() const { return file_.is_open(); }

 private:
  Editor& editor_;
  std::ofstream file_;
};

}  // namespace cagewright::host

#endif
