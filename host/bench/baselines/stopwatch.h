// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ctime>

namespace cagewright::bench {

// Processor time of this process since it was made: other programs on the machine do not count.
class Stopwatch {
 public:
  double seconds() const { return static_cast<double>(std::clock() - start_) / CLOCKS_PER_SEC; }

 private:
  std::clock_t start_ = std::clock();
};

}  // namespace cagewright::bench
