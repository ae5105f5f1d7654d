// SPDX-License-Identifier: BSD-3-Clause
#include "core/enclose/nearest_slide.h"

#include <algorithm>

namespace cagewright {

std::vector<int> slides_of_part(const Segmentation& segmentation, int part) {
  std::vector<int> slides;
  for (const PartSection& side : segmentation.parts[static_cast<std::size_t>(part)].sections)
    slides.push_back(side.slide);
  return slides;
}

int nearest_slide(const Segmentation& segmentation, const std::vector<int>& slides, const Vector3& point) {
  const auto distance = [&](int k) {
    return (segmentation.ellipses[static_cast<std::size_t>(k)].center - point).squaredNorm();
  };
  const auto nearest =
      std::min_element(slides.begin(), slides.end(), [&](int a, int b) { return distance(a) < distance(b); });
  return nearest == slides.end() ? -1 : *nearest;
}

}  // namespace cagewright
