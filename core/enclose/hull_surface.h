// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <vector>

#include "core/enclose/arrangement.h"
#include "core/enclose/outer_sides.h"

namespace cagewright {

// A border between parts of two sources on the hull, straight from one of its vertices to the next.
struct HullEdge {
  int from = 0, to = 0;                // points, as the source on its left runs
  int from_vertex = 0, to_vertex = 0;  // of the surface
  int id = 0;                          // the same for the two sources that it parts
  bool is_turned = false;              // the source on its left faces inward as it runs
};

// The kept faces as a surface: a 2-manifold whose vertices are places of the arrangement, with as many copies as sheets
// touch there. Only such vertices stay as bound the part of a source that is kept.
struct HullSurface {
  std::vector<int> point_of;                   // of each vertex
  std::vector<std::vector<int>> faces_of;      // of each vertex: the kept faces at it
  std::vector<char> stays, is_touching;        // of each vertex
  std::vector<std::vector<HullEdge>> borders;  // of each source: round what is kept of it
};

// Precondition: `sides` are the arrangement's. Throws Error(internal).
HullSurface find_hull_surface(const Arrangement& arrangement, const OuterSides& sides);

}  // namespace cagewright
