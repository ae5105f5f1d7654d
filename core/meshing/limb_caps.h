// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "core/orient/orient.h"
#include "core/segment/segment.h"

namespace cagewright {

using CapCorners = std::array<Vector3, 4>;

// Rectangular caps for the limbs that no slide cuts off yet (not in the paper): what of a part reaches far beyond the
// convex hull of `corners`, those of its sections and, of a leaf, its cap. Without them the sections alone would have
// to grow until they hold such a limb.
//
// As long as a vertex of the part is farther outside the hull of all corners so far than tolerance::far_of_sections
// times the half side of its sections, in the mean, and tolerance::far_of_hull of the hull's size, the farthest one
// gets a cap: through it (of several that are as far above one face of the hull, their middle), across the direction
// from the hull to it, around what reaches at least half as far. At most tolerance::most_limb_caps.
//
// The caps in the order found; above faces with equally far vertices, the one farthest from the corners' middle first.
// `sections`: those that bound the part, not empty. Turns, moves and scales with the model. Thread-safe. O(caps *
// part).
std::vector<CapCorners> limb_caps(const Points& points, const Part& part, std::vector<Vector3> corners,
                                  const std::vector<SectionFrame>& sections);

}  // namespace cagewright
