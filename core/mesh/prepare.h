// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/mesh/edge_blocks.h"
#include "core/mesh/half_edge_mesh.h"
#include "core/mesh/inspect.h"
#include "core/mesh/types.h"

namespace cagewright {

// A model that every stage can rely on: a closed, consistently oriented 2-manifold with outward normals.
struct Model {
  HalfEdgeMesh mesh;
  EdgeBlocks edge_blocks;                            // of the mesh
  std::vector<int> given_vertices, given_triangles;  // of each of the mesh's: a row of the input at the same place
  MeshReport report;                                 // of the input, with turned_triangles filled in
  double diagonal = 0;            // of the bounding box, model units; every tolerance is relative to it
  double volume = 0;              // > 0
  std::uint64_t fingerprint = 0;  // of the input's points and triangles: same input, same number
};

// Makes a Model of whatever a file held: welds vertices at equal positions, drops degenerate triangles and unused
// vertices, splits bow-tie vertices, orients every component consistently and turns outward what is inside out: every
// component that lies in no other, together with all that lies in it, so that a cavity stays one.
// Throws Error: those of inspect, mesh_open and mesh_non_manifold (the sentence counts them and tells the first place),
// mesh_not_orientable, mesh_empty (no volume), mesh_not_finite (a volume that no double holds). Thread-safe.
// O(n log n) where components are far fewer than triangles.
Model prepare_model(const IndexedMesh& mesh);

}  // namespace cagewright
