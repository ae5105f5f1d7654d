// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/enclose/movable_cage.h"

namespace cagewright {

// What of the model is not inside the cage.
struct Outside {
  std::vector<char> vertices;             // of each vertex of the cut model
  std::vector<std::vector<int>> meeting;  // of each cage triangle: the model triangles that it meets, ascending
  bool none = true;
};

// The edges of the model, from vertex to vertex: built once.
struct VertexNeighbours {
  std::vector<int> first, triangles;  // vertex v is in triangles[first[v]] up to triangles[first[v + 1]]
  explicit VertexNeighbours(const IndexedMesh& model);
};

// Exact where the cage does not meet itself: the vertices of triangles that meet the cage by winding numbers, the
// others by what they are joined to. A component that is outside altogether is not found. `gap`: nearer than that is
// meeting. The same for any number of threads. O(meeting * log n + outside).
Outside find_outside(const MovableCage& movable, const VertexNeighbours& neighbours, double gap, unsigned threads);

}  // namespace cagewright
