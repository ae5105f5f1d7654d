// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>
#include <vector>

#include "core/enclose/movable_cage.h"

namespace cagewright {

struct MergeOptions {
  double clearance = 0;    // the distance to the model that is wanted, model units
  double gap = 0;          // between cage triangles; model units
  bool to_floats = false;  // new points are floats
};

struct MergedLimbs {
  Cage cage;                                // section_vertices is set; without triangles where nothing is left
  std::vector<std::pair<int, int>> slides;  // nearest to where limbs became one, the lower first; longest seams first
};

// Makes one of limbs whose walls run into each other: the outer hull of the cage (outer_hull.h), without the pieces in
// which there is no model, and with few triangles more. Given vertices come first, in their order; sections that have
// lost a corner are no longer whole. Where walls bound their own model, the hull bounds it all. Throws Error(internal).
MergedLimbs merge_limbs(const MovableCage& movable, const MergeOptions& options);

}  // namespace cagewright
