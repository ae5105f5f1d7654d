// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "core/mesh/types.h"

namespace cagewright {

// A mesh without two vertices at the same position, without triangles that name a vertex twice and without unused
// vertices. welded + unused + rows of mesh.points = rows of the input's points.
struct WeldedMesh {
  IndexedMesh mesh;                      // vertices and triangles in the order in which the input first names them
  Triangles given;                       // the kept triangles as the input names them: rows of its points
  std::vector<int> given_rows;           // of the kept triangles, in the input
  std::size_t welded_vertices = 0;       // merged into an earlier one at the same position
  std::size_t degenerate_triangles = 0;  // dropped
  std::size_t unused_vertices = 0;       // dropped: named by no kept triangle
};

// Merges vertices whose positions are equal bit for bit (-0 equals 0); the first of them stays.
// Throws Error: mesh_empty (no triangle, or none but degenerate ones), mesh_not_finite (element = vertex), mesh_index
// (element = triangle). Thread-safe. O(n).
WeldedMesh weld(const IndexedMesh& mesh);

// Of each vertex the first of the input's rows that a kept triangle names for it. Precondition: no triangle has been
// turned since. Thread-safe. O(n).
std::vector<int> find_given_vertices(const WeldedMesh& welded);

}  // namespace cagewright
