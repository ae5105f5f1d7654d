// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "core/mesh/connectivity.h"
#include "core/mesh/volume.h"

namespace cagewright {

// Which triangles to turn so that every edge is run once in each direction.
struct Turns {
  std::vector<bool> turned;             // of each triangle
  std::optional<int> conflicting_edge;  // where the turns fail: the surface is not orientable
};

// Floods every component from its first triangle, then turns the fewer of its triangles (as many: not the first).
// Precondition: no edge has more than two triangles. O(n).
Turns find_consistent_turns(const Triangles& triangles, const Connectivity& connectivity);

// Turns triangle t: its first corner stays the first.
void turn(Triangles& triangles, Eigen::Index t);

// Whether each component has to be turned so that the outermost ones have positive volume. What lies inside an
// outermost component is turned with it, so that a cavity stays one. Precondition: closed, consistently oriented.
// O(n log n) where components are far fewer than triangles.
std::vector<bool> find_inside_out(const IndexedMesh& mesh, const Labels& components, const Volumes& volumes);

}  // namespace cagewright
