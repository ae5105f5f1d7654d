// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/enclose/enclose.h"
#include "core/enclose/movable_cage.h"

namespace cagewright {

// Both move one vertex at a time against the gradient of the cage's volume, sliding along the triangles that would run
// into something, and adapt the vertex's step. Planes as in RefineRecord. O(sweeps * vertices * log n).

// While anything but its own model is in a triangle's way (other cage triangles, other parts' model): moves that bring
// no triangle into its own model and no more of the rest. Returns whether nothing is in the way any more.
bool untangle(MovableCage& movable, const Points& plane_normals, double diagonal, const Progress& progress);

// While volume comes off: moves after which no triangle at the vertex runs into anything. Returns the sweeps.
// Precondition: nothing is in the way of any triangle; that stays so.
int tighten(MovableCage& movable, const Points& plane_normals, double diagonal, const Progress& progress);

}  // namespace cagewright
