// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>

#include "testdata/generate/triangle_mesh.h"

namespace cagewright::testdata {

// What a triangle mesh is, counted by index as it stands: equal positions are not merged first.
struct MeshFacts {
  std::size_t vertices = 0, triangles = 0;
  std::size_t open_edges = 0;          // with one triangle
  std::size_t non_manifold_edges = 0;  // with three triangles or more
  std::size_t inconsistent_edges = 0;  // with two triangles that run it in the same direction
  std::size_t bow_tie_vertices = 0;    // whose triangles form more than one fan
  std::size_t unused_vertices = 0;
  std::size_t repeated_positions = 0;    // vertices at a position that an earlier vertex has
  std::size_t degenerate_triangles = 0;  // without area
  std::size_t components = 0;            // of triangles that share vertices
  int genus = -1;                        // of the whole; -1 unless closed, manifold and consistently oriented
  double volume = 0;                     // signed: positive where triangles face outward

  bool closed() const { return triangles > 0 && open_edges == 0 && non_manifold_edges == 0; }
  bool manifold() const { return closed() && inconsistent_edges == 0 && bow_tie_vertices == 0; }
};

// O(n log n). Corners must be indices of vertices.
MeshFacts count_facts(const TriangleMesh& mesh);

// What keeps the mesh from being one closed, manifold, outward-facing piece of this genus: the rest of a sentence that
// begins with the mesh's name. Empty where nothing does.
std::string broken_promise(const MeshFacts& facts, int genus);

}  // namespace cagewright::testdata
