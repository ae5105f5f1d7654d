// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_SCENE_SLIDE_IDS_H
#define CAGEWRIGHT_HOST_SCENE_SLIDE_IDS_H

#include <cstdint>
#include <set>

namespace cagewright::host {

// What every JSON reader can hold as a whole number.
inline constexpr std::int64_t largest_slide_id = std::int64_t{1} << 53;

// The ids that are taken.
class SlideIds {
 public:
  void take(std::int64_t id) { taken_.insert(id); }
  // Takes one that is free: the next after the largest, where there is one. O(log n), amortised.
  std::int64_t take_next();

 private:
  std::set<std::int64_t> taken_;
  std::int64_t least_free_ = 1;  // no smaller one is free
};

}  // namespace cagewright::host

#endif
