// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "core/mesh/types.h"

namespace cagewright {

struct ConvexHull {
  std::vector<std::array<int, 3>> triangles;  // counter-clockwise from outside, rows of the points
  std::vector<std::pair<Vector3, double>>
      planes;  // of each triangle: outward unit n and offset, n.x + offset <= 0 inside
};

// The hull by Qhull, joggled so that it is simplicial and every extreme point is a vertex even where four or more
// points are coplanar. Deterministic. Where the points are flat, a hull of the joggled points without
// volume to speak of; empty where Qhull gives up, as on fewer than 4 points. Thread-safe. O(n log n).
ConvexHull convex_hull(const std::vector<Vector3>& points);

}  // namespace cagewright
