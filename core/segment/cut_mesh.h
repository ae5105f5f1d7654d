// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "core/mesh/prepare.h"
#include "core/slide/plane_loops.h"

namespace cagewright {

// A mesh that is cut along one loop after another. Cutting splits the crossed triangles; the loop's edges are then
// edges of the mesh, each owned by its slide.
class CutMesh {
 public:
  explicit CutMesh(const Model& model) : mesh_(model.mesh), blocks_(model.edge_blocks), diagonal_(model.diagonal) {}

  const HalfEdgeMesh& mesh() const { return mesh_; }
  const EdgeBlocks& edge_blocks() const { return blocks_; }

  // Splits the mesh along `loop`, which plane_loops found on mesh(), for slide number `slide`; returns the loop's
  // half-edges with the triangles ahead of the slide on their left. `names` are the slides', for the sentence.
  // Throws Error(slides_touch) where the loop meets that of an earlier slide; the mesh is then unusable.
  // O(length of the loop), amortised.
  std::vector<OpenMesh::HalfedgeHandle> cut(const PlaneLoop& loop, int slide, const std::vector<std::string>& names);

  // The slide that owns an edge, or -1.
  int slide_of(OpenMesh::EdgeHandle edge) const { return owner(edge_slide_, edge.idx()); }

 private:
  static int owner(const std::vector<int>& owners, int index) {
    return static_cast<std::size_t>(index) < owners.size() ? owners[static_cast<std::size_t>(index)] : -1;
  }
  void check_apart(const PlaneLoop& loop, int slide, const std::vector<std::string>& names) const;

  HalfEdgeMesh mesh_;
  EdgeBlocks blocks_;
  double diagonal_;
  std::vector<int> edge_slide_;    // by edge, short at the end: -1
  std::vector<int> vertex_slide_;  // by vertex, short at the end: -1
};

}  // namespace cagewright
