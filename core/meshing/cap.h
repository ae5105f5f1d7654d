// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "core/orient/orient.h"
#include "core/segment/segment.h"

namespace cagewright {

// The rectangular cap of a leaf part (paper 3.3, inset): the section pushed to the far end of the part and rescaled to
// the part's extent there (over the farther half), with the section's directions p and q. Corner i faces corner i of
// the section. `into` is the unit direction from the section into the part. O(part).
std::array<Vector3, 4> cap_of(const Points& points, const Part& part, const SectionFrame& section, const Vector3& into);

// The axis-aligned bounding box of a part that no slide bounds, thickened where the part is flat. Corner i has the
// upper x, y, z where bit 0, 1, 2 of i is set. O(part).
std::array<Vector3, 8> box_of(const Points& points, const Part& part);

// The 12 triangles of box_of's corners, outward.
extern const std::array<std::array<int, 3>, 12> box_triangles;

}  // namespace cagewright
