// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <vector>

#include "core/enclose/triangle_intersection.h"

namespace cagewright {

struct SimplifyOptions {
  std::vector<char> is_fixed;  // of each vertex: it stays where it is
  double most_volume = 0;      // that one collapse may add or take, model units cubed
  // Whether a triangle is in nobody's way but the mesh's own. Null: any is. The same may be asked again.
  std::function<bool(const Triangle3&)> is_allowed;
};

struct Simplified {
  IndexedMesh mesh;
  std::vector<int> triangle_row, vertex_row;  // of what is left, in the mesh given; ascending
};

// Collapses the edges of a closed 2-manifold to their ends or middles, those first that change the volume least, while
// it stays a 2-manifold, no triangle that changes meets another (exactly) or loses its area, and all are allowed.
// Deterministic. O(collapses tried * triangles).
Simplified simplify_hull(const IndexedMesh& mesh, const SimplifyOptions& options);

}  // namespace cagewright
