// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/enclose/triangle_intersection.h"

namespace cagewright {

// Between two triangles that do not meet; for those that do, something between 0 and the distance of their borders.
// Floating point; degenerate triangles are allowed. O(1).
double triangle_distance(const Triangle3& s, const Triangle3& t);

}  // namespace cagewright
