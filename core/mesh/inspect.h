// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "core/mesh/types.h"

namespace cagewright {

struct WeldedMesh;
struct Connectivity;

// What a mesh is. Counted after welding by position and after dropping triangles that name a position twice.
struct MeshReport {
  std::size_t vertices = 0;  // used by a triangle
  std::size_t triangles = 0;
  std::size_t welded_vertices = 0;       // merged into another at the same position
  std::size_t degenerate_triangles = 0;  // dropped
  std::size_t unused_vertices = 0;
  std::size_t open_edges = 0;  // with one triangle
  std::size_t non_manifold_edges =
      0;  // with more than two, unless the input's vertices tell them apart (welded_edges.h)
  std::size_t inconsistent_edges = 0;  // with two triangles that run it in the same direction
  std::size_t bow_tie_vertices = 0;    // where several fans meet
  std::size_t components = 0;          // connected by shared edges
  std::size_t turned_triangles = 0;    // set by prepare_model: turned for a consistent, outward orientation
  bool inside_out = false;             // closed, consistently oriented, and the signed volume is negative
  std::optional<long> genus;           // of the whole, bow-ties split; empty where not closed or not orientable
  double signed_volume = 0;            // model units cubed, of the triangles as given
  Vector3 box_min = Vector3::Zero(), box_max = Vector3::Zero();  // of the used vertices
  std::optional<Vector3> first_open_edge, first_non_manifold_edge, first_inconsistent_edge, first_bow_tie;  // midpoints

  bool closed() const { return triangles > 0 && open_edges == 0 && non_manifold_edges == 0; }
  bool consistently_oriented() const { return inconsistent_edges == 0; }
  double diagonal() const { return (box_max - box_min).stableNorm(); }
};

// Counts what `mesh` is; refuses nothing but what is no mesh at all.
// Throws Error: mesh_empty (no triangle, or none but degenerate ones), mesh_not_finite (element = vertex), mesh_index
// (element = triangle). Thread-safe. O(n log n).
MeshReport inspect(const IndexedMesh& mesh);

// The same of a mesh that is already welded. O(n).
MeshReport inspect(const WeldedMesh& welded, const Connectivity& connectivity);

// Half-edges as in connectivity.h.
Vector3 edge_midpoint(const IndexedMesh& mesh, int half_edge);

}  // namespace cagewright
