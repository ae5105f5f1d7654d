// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "core/mesh/half_edge_mesh.h"

namespace cagewright {

// The edges of a mesh in boxes of some that are near each other, so that a plane need not look at every one. Keeps
// nothing of the mesh.
class EdgeBlocks {
 public:
  EdgeBlocks() = default;  // of a mesh without edges
  // O(n log n).
  explicit EdgeBlocks(const HalfEdgeMesh& mesh);

  // After edges were split: `mesh` has more edges, those that it had are still where they were, or on a piece of that.
  // O(edges that are new).
  void add_new_edges(const HalfEdgeMesh& mesh);

  // Calls `visit` with all edges that meet the plane through `point` with the unit normal `normal`, but for rounding,
  // and with others near it; in no order that means anything. O(n / 16 + k), k of them.
  template <class Visit>
  void visit_near_plane(const Vector3& point, const Vector3& normal, const Visit& visit) const {
    const double slack = slack_of(point, normal);
    for (const Block& block : blocks_)
      if (block.is_near(point, normal, slack))
        for (std::size_t i = block.begin; i < block.end; ++i) visit(edges_[i]);
  }
  // No vertex is farther from that plane. O(1).
  double farthest_from(const Vector3& point, const Vector3& normal) const;

 private:
  struct Block {
    std::size_t begin = 0, end = 0;  // of edges_
    Eigen::AlignedBox3d box;
    bool is_near(const Vector3& point, const Vector3& normal, double slack) const;
  };
  double slack_of(const Vector3& point, const Vector3& normal) const;
  void add_block(const HalfEdgeMesh& mesh, std::size_t begin);

  std::vector<int> edges_;  // at first along a curve that fills space
  std::vector<Block> blocks_;
  Eigen::AlignedBox3d all_;
};

}  // namespace cagewright
