// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/enclose/outside.h"

namespace cagewright {

// What of the model its own walls do not bound, whatever else is round it: of a model vertex, those of its part and,
// near slides, of the parts beyond, closed by the sections at which they end. `meeting` has own model only. Exact where
// no part's walls meet each other. The same for any number of threads. O(meeting * log n + outside).
Outside find_own_outside(const MovableCage& movable, const VertexNeighbours& neighbours, double gap, unsigned threads);

// The parts of the triangles at a model vertex, and those beyond, ascending.
std::vector<int> find_own_parts(const MovableCage& movable, const VertexNeighbours& neighbours, int vertex);

}  // namespace cagewright
