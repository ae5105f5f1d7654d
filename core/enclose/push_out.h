// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/enclose/enclose.h"
#include "core/enclose/movable_cage.h"

namespace cagewright {

// Equation (6) looks at the vertices that are seen through a cage triangle, so that a model triangle which crosses it
// from the side is bounded by nobody. Here a triangle that runs into its own model is anchored, (7a), just beyond the
// farthest vertex of what it runs into, all others at their barycentres, (7b); then equation (8) is solved within the
// trust region of the refinement, and again, until none runs into its own model or `most` steps are done. Returns the
// steps. `plane_normals` as in RefineRecord. O(steps * n).
int push_out(MovableCage& movable, const Segmentation& segmentation, const Cage& cage, const Points& plane_normals,
             double diagonal, const EncloseOptions& options, int most, const Progress& progress);

}  // namespace cagewright
