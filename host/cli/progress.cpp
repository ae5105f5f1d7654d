// SPDX-License-Identifier: BSD-3-Clause
#include "host/cli/progress.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <iostream>

#include "host/cli/text.h"

namespace cagewright::host {

Progress::Progress(bool quiet) : is_quiet_(quiet), is_terminal_(::isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() { clear_line(); }

void Progress::clear_line() {
  if (has_line_) std::cerr << "\r\033[K" << std::flush;
  has_line_ = false;
}

void Progress::show(double fraction, const std::string& stage) {
  if (is_quiet_) return;
  const bool is_new_stage = stage != stage_;
  stage_ = stage;
  if (!is_terminal_) {
    if (is_new_stage) std::cerr << "cagewright: " << one_line(stage) << "\n";
    return;
  }
  const int percent = std::isfinite(fraction) ? static_cast<int>(100 * std::clamp(fraction, 0.0, 1.0)) : 0;
  if (!is_new_stage && percent == percent_) return;
  percent_ = percent;
  clear_line();
  std::cerr << "cagewright: " << percent << " % " << one_line(stage) << std::flush;
  has_line_ = true;
}

void Progress::note(const std::string& sentence) {
  if (is_quiet_) return;
  clear_line();
  std::cerr << "cagewright: " << one_line(sentence) << "\n";
}

}  // namespace cagewright::host
