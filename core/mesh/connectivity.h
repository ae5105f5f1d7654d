// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

#include "core/mesh/types.h"

namespace cagewright {

// Half-edge 3 t + i of a triangle mesh runs from corner i of triangle t to its next corner.
inline int next_in_triangle(int half_edge) { return half_edge % 3 == 2 ? half_edge - 2 : half_edge + 1; }
inline int from_vertex(const Triangles& triangles, int half_edge) { return triangles.data()[half_edge]; }
inline int to_vertex(const Triangles& triangles, int half_edge) {
  return triangles.data()[next_in_triangle(half_edge)];
}

// The edges of any triangle mesh, each with all half-edges that run along it in either direction.
struct EdgeTable {
  std::vector<int> half_edges;  // grouped by edge, ascending within an edge
  std::vector<int> first;       // edge e owns half_edges[first[e]] up to half_edges[first[e + 1]]

  int count() const { return static_cast<int>(first.size()) - 1; }
  std::span<const int> of(int edge) const {
    return {half_edges.data() + first[edge], static_cast<std::size_t>(first[edge + 1] - first[edge])};
  }
};

// Precondition for all below: indices are in range and no triangle names a vertex twice (see weld.h).
// The edges by their lower, then by their upper vertex. O(n log k), k = most edges at a vertex.
EdgeTable find_edges(const Triangles& triangles, Eigen::Index vertices);

// Of each half-edge the other one of its edge; -1 where the edge has not exactly two. O(n).
std::vector<int> find_opposites(const EdgeTable& edges);

// Classes numbered from 0 in order of first occurrence.
struct Labels {
  std::vector<int> of;
  int count = 0;
};

// Of each triangle the component: triangles connected through shared edges. O(n).
Labels find_components(const Triangles& triangles, const EdgeTable& edges);

// Of each corner 3 t + i the fan: the corners at a vertex connected through the edges at it. A vertex with more than
// one fan is a bow-tie. O(n).
Labels find_fans(const Triangles& triangles, const EdgeTable& edges);

struct Connectivity {
  EdgeTable edges;
  Labels components, fans;
};
Connectivity connect(const IndexedMesh& mesh);

// The same, but edges that only the weld made coincide stay apart where they can (see welded_edges.h).
struct WeldedMesh;
Connectivity connect(const WeldedMesh& welded);

}  // namespace cagewright
