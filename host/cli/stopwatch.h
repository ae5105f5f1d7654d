// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_CLI_STOPWATCH_H
#define CAGEWRIGHT_HOST_CLI_STOPWATCH_H

#include <chrono>

namespace cagewright::host {

// Runs from when it is made.
class Stopwatch {
 public:
  double milliseconds() const {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin_).count();
  }

 private:
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

}  // namespace cagewright::host

#endif
