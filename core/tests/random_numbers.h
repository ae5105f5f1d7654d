// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <random>

#include "core/mesh/types.h"

namespace cagewright {

// The same numbers with every standard library.
class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double uniform(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_()) / static_cast<double>(std::mt19937::max());
  }
  int below(int count) { return static_cast<int>(engine_() % static_cast<unsigned long>(count)); }
  Vector3 direction() {
    Vector3 v;
    do v = Vector3(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1));
    while (v.norm() > 1 || v.norm() < 0.1);
    return v.normalized();
  }

 private:
  std::mt19937 engine_;
};

}  // namespace cagewright
