// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/mesh/types.h"

namespace cagewright {

struct OuterHull {
  IndexedMesh mesh;                  // closed 2-manifold, outward; without a triangle where there is nothing inside
  std::vector<int> triangle_source;  // of each triangle: the given one that it is part of; ascending
  std::vector<int> vertex_source;    // of each vertex: the given one (ascending, first), or -1: new
  // Vertices of places where two sheets of the hull touch, ascending: copies of one place, or on another sheet.
  std::vector<int> touching;
};

// The boundary of what cannot be reached from infinity without passing a triangle (paper, figure 18): of each component
// that lies in no other. Found exactly; new points are then rounded to doubles. Triangles that are on it as a whole
// stay as they are, vertices keep their coordinates and their order; of others the part that is on it is triangulated
// anew, with no more points than its corners and what crosses its edges. Sheets that touch each other along an edge or
// in a point get vertices of their own there, which are drawn inward by `apart` (model units; 0: they touch). Where
// such a sheet is a saddle there is no inward, and it may still touch.
// Precondition: finite points, indices in range; every edge has as many triangles in one direction as in the other.
// Triangles without area, doubled vertices and overlaps in a plane are allowed. Throws Error(internal). Thread-safe.
// O(n log n + pairs that meet + sum over triangles of (what meets it)^2).
OuterHull outer_hull(const IndexedMesh& mesh, double apart = 0);

}  // namespace cagewright
