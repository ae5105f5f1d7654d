// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_CLI_PROGRESS_H
#define CAGEWRIGHT_HOST_CLI_PROGRESS_H

#include <string>

namespace cagewright::host {

// Progress and notes on stderr: on a terminal one line that is rewritten, otherwise a line for each stage, none where
// quiet. The rewritten line is gone before anything else is said, and at the end.
class Progress {
 public:
  explicit Progress(bool quiet);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void show(double fraction, const std::string& stage);
  void note(const std::string& sentence);

 private:
  void clear_line();

  bool is_quiet_;
  bool is_terminal_;
  bool has_line_ = false;
  std::string stage_;
  int percent_ = -1;
};

}  // namespace cagewright::host

#endif
