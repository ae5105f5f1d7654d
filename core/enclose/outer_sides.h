// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>
#include <vector>

#include "core/enclose/arrangement.h"

namespace cagewright {

// The boundary of what cannot be reached from infinity without passing a face.
struct OuterSides {
  enum class Kept : char { no, as_it_is, turned };
  std::vector<Kept> faces;  // of each face; of faces that lie on each other one at most
  // Of edge 3 f + i of each kept face the edge 3 g + j of the kept face that bounds the same solid there, else -1. So
  // solids that touch along an edge stay two.
  std::vector<int> partners;
};

// Exact. Precondition: `mesh` is the one that was arranged; every edge of it has as many triangles in one direction as
// in the other. Throws Error(internal). O(n log n) but for the edges that many faces share.
OuterSides find_outer_sides(const IndexedMesh& mesh, const Arrangement& arrangement);

}  // namespace cagewright
