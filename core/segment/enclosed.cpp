// SPDX-License-Identifier: BSD-3-Clause
#include "core/segment/enclosed.h"

#include <algorithm>

#include "core/mesh/connectivity.h"
#include "core/mesh/nesting.h"
#include "core/mesh/volume.h"

namespace cagewright {

void mark_enclosed(Segmentation& segmentation) {
  const bool any = std::any_of(segmentation.parts.begin(), segmentation.parts.end(),
                               [](const Part& part) { return part.sections.empty(); });
  if (!any || segmentation.parts.size() < 2) return;
  const Connectivity connectivity = connect(segmentation.cut);
  const Labels& components = connectivity.components;
  const std::vector<int> outermost =
      find_outermost(segmentation.cut, components, find_volumes(segmentation.cut, components));
  for (std::size_t t = 0; t < components.of.size(); ++t) {
    Part& part = segmentation.parts[static_cast<std::size_t>(segmentation.triangle_part[t])];
    const int component = components.of[t];
    if (part.sections.empty()) part.enclosed = outermost[static_cast<std::size_t>(component)] != component;
  }
}

}  // namespace cagewright
