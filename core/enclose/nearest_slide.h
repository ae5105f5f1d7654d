// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/segment/segment.h"

namespace cagewright {

// Of the sections that bound a part, in their order there.
std::vector<int> slides_of_part(const Segmentation& segmentation, int part);

// Of `slides` the one whose ellipse has its centre nearest to the point, the first of several; -1: there are none. O(1)
// a slide.
int nearest_slide(const Segmentation& segmentation, const std::vector<int>& slides, const Vector3& point);

}  // namespace cagewright
