// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/enclose/movable_cage.h"

namespace cagewright {

// The steps of a cage's vertices, each the shortest that takes it out over the planes of all its triangles by
// `distance` (model units) or, where that asks for too long a step, nearly so. `plane_normals`: of each vertex the unit
// normal that it moves across only; zero: free. O(triangles).
Points offset_walls(const MovableCage& movable, const Points& plane_normals, double distance);

}  // namespace cagewright
