// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <numeric>
#include <vector>

namespace cagewright {

// Sets of numbers from 0; the lowest of a set stands for it.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count) : up_(count) { std::iota(up_.begin(), up_.end(), 0); }
  int of(int k) {
    while (up(k) != k) {
      up(k) = up(up(k));
      k = up(k);
    }
    return k;
  }
  void join(int a, int b) {
    a = of(a);
    b = of(b);
    up(std::max(a, b)) = std::min(a, b);
  }

 private:
  int& up(int k) { return up_[static_cast<std::size_t>(k)]; }
  std::vector<int> up_;
};

}  // namespace cagewright
