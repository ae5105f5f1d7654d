// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "core/mesh/types.h"

namespace cagewright {

// The convex hull's triangles, counter-clockwise from outside, rows of `points`. By Qhull, joggled so that the hull is
// simplicial and every extreme point is a vertex even where four or more points are coplanar. Deterministic. Where the
// points are flat, a hull of the joggled points without volume to speak of; empty where Qhull gives up, as on fewer
// than 4 points. Thread-safe. O(n log n).
std::vector<std::array<int, 3>> hull_triangles(const std::vector<Vector3>& points);

struct HullPlane {
  Vector3 normal;  // outward unit
  double offset;   // normal . x + offset <= 0 inside
};

// The planes of the convex hull's faces, not joggled: coplanar facets are merged, so one for each flat face but for
// rounding. Empty where the points are flat. By Qhull; thread-safe. O(n log n).
std::vector<HullPlane> hull_planes(const std::vector<Vector3>& points);

}  // namespace cagewright
