// SPDX-License-Identifier: BSD-3-Clause
#include "core/mesh/edge_blocks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/mesh/morton.h"
#include "core/mesh/tolerance.h"

namespace cagewright {
namespace {

constexpr std::size_t block_size = 16;

struct Ends {
  Vector3 from, to;
};

Ends ends_of(const HalfEdgeMesh& mesh, int edge) {
  const auto h = mesh.halfedge_handle(OpenMesh::EdgeHandle(edge), 0);
  return {mesh.point(mesh.from_vertex_handle(h)), mesh.point(mesh.to_vertex_handle(h))};
}

// How far a box reaches along a direction from its centre.
double half_width(const Eigen::AlignedBox3d& box, const Vector3& direction) {
  return direction.cwiseAbs().dot(box.sizes()) / 2;
}

}  // namespace

EdgeBlocks::EdgeBlocks(const HalfEdgeMesh& mesh) {
  const auto count = static_cast<int>(mesh.n_edges());
  for (const auto v : mesh.vertices()) all_.extend(mesh.point(v));
  const double side = std::max(all_.isEmpty() ? 0 : all_.sizes().maxCoeff(), std::numeric_limits<double>::min());
  std::vector<std::pair<std::uint64_t, int>> keys;
  keys.reserve(mesh.n_edges());
  for (int e = 0; e < count; ++e) {
    const auto [from, to] = ends_of(mesh, e);
    keys.emplace_back(morton_code(((from - all_.min()) + (to - all_.min())) / 2 / side), e);
  }
  std::sort(keys.begin(), keys.end());
  edges_.reserve(keys.size());
  blocks_.reserve(keys.size() / block_size + 1);
  for (std::size_t i = 0; i < keys.size(); ++i) {
    edges_.push_back(keys[i].second);
    if (edges_.size() % block_size == 0 || i + 1 == keys.size()) add_block(mesh, i / block_size * block_size);
  }
}

void EdgeBlocks::add_new_edges(const HalfEdgeMesh& mesh) {
  const std::size_t begin = edges_.size();
  for (std::size_t e = begin; e < mesh.n_edges(); ++e) edges_.push_back(static_cast<int>(e));
  add_block(mesh, begin);
}

void EdgeBlocks::add_block(const HalfEdgeMesh& mesh, std::size_t begin) {
  Block block{begin, edges_.size(), {}};
  for (std::size_t i = begin; i < edges_.size(); ++i) {
    const auto [from, to] = ends_of(mesh, edges_[i]);
    block.box.extend(from).extend(to);
  }
  blocks_.push_back(block);
}

bool EdgeBlocks::Block::is_near(const Vector3& point, const Vector3& normal, double slack) const {
  return std::abs(normal.dot(box.center() - point)) <= half_width(box, normal) + slack;
}

double EdgeBlocks::farthest_from(const Vector3& point, const Vector3& normal) const {
  return all_.isEmpty() ? 0 : std::abs(normal.dot(all_.center() - point)) + half_width(all_, normal);
}

// Above what rounding moves a height by, and what plane_loops takes for on the plane.
double EdgeBlocks::slack_of(const Vector3& point, const Vector3& normal) const {
  return 2 * tolerance::tie * farthest_from(point, normal);
}

}  // namespace cagewright
