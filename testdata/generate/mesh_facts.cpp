// SPDX-License-Identifier: BSD-3-Clause
#include "testdata/generate/mesh_facts.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <numeric>
#include <tuple>

namespace cagewright::testdata {
namespace {

// Disjoint sets with path halving.
class Sets {
 public:
  explicit Sets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), std::size_t{0}); }
  std::size_t find(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::size_t a, std::size_t b) { parent_[find(a)] = find(b); }

 private:
  std::vector<std::size_t> parent_;
};

struct HalfEdge {
  std::uint32_t low, high;
  bool upward;  // runs from low to high
  std::size_t low_corner, high_corner;
};

std::vector<HalfEdge> sorted_half_edges(const TriangleMesh& mesh) {
  std::vector<HalfEdge> edges;
  edges.reserve(3 * mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t next = (k + 1) % 3;
      const std::uint32_t a = mesh.triangles[t][k];
      const std::uint32_t b = mesh.triangles[t][next];
      if (a < b)
        edges.push_back({a, b, true, 3 * t + k, 3 * t + next});
      else
        edges.push_back({b, a, false, 3 * t + next, 3 * t + k});
    }
  }
  std::ranges::sort(edges, {}, [](const HalfEdge& e) { return std::tuple(e.low, e.high, e.low_corner); });
  return edges;
}

// Fans of triangles round vertices are sets of corners joined across shared edges.
std::size_t count_edges(const TriangleMesh& mesh, MeshFacts& facts, Sets& fans) {
  const std::vector<HalfEdge> edges = sorted_half_edges(mesh);
  std::size_t distinct = 0;
  for (std::size_t i = 0; i < edges.size(); ++distinct) {
    std::size_t end = i + 1;
    for (; end < edges.size() && edges[end].low == edges[i].low && edges[end].high == edges[i].high; ++end) {
      fans.join(edges[i].low_corner, edges[end].low_corner);
      fans.join(edges[i].high_corner, edges[end].high_corner);
    }
    if (end - i == 1) ++facts.open_edges;
    if (end - i > 2) ++facts.non_manifold_edges;
    if (end - i == 2 && edges[i].upward == edges[i + 1].upward) ++facts.inconsistent_edges;
    i = end;
  }
  return distinct;
}

void count_vertices(const TriangleMesh& mesh, MeshFacts& facts, Sets& fans) {
  std::vector<std::size_t> fans_of(mesh.vertices.size(), 0);
  Sets pieces(mesh.vertices.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& corners = mesh.triangles[t];
    for (std::size_t k = 0; k < 3; ++k)
      if (fans.find(3 * t + k) == 3 * t + k) ++fans_of[corners[k]];
    pieces.join(corners[0], corners[1]);
    pieces.join(corners[0], corners[2]);
  }
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    if (fans_of[v] == 0) ++facts.unused_vertices;
    if (fans_of[v] > 1) ++facts.bow_tie_vertices;
    if (fans_of[v] > 0 && pieces.find(v) == v) ++facts.components;
  }
}

std::size_t count_repeated(const TriangleMesh& mesh) {
  std::vector<std::array<double, 3>> positions;
  for (const Eigen::Vector3d& v : mesh.vertices) positions.push_back({v[0], v[1], v[2]});
  std::ranges::sort(positions);
  const auto tail = std::ranges::unique(positions);
  return tail.size();
}

}  // namespace

MeshFacts count_facts(const TriangleMesh& mesh) {
  MeshFacts facts;
  facts.vertices = mesh.vertices.size();
  facts.triangles = mesh.triangles.size();
  Sets fans(3 * mesh.triangles.size());
  const std::size_t edges = count_edges(mesh, facts, fans);
  count_vertices(mesh, facts, fans);
  facts.repeated_positions = count_repeated(mesh);
  for (const auto& [ia, ib, ic] : mesh.triangles) {
    const Eigen::Vector3d &a = mesh.vertices[ia], &b = mesh.vertices[ib], &c = mesh.vertices[ic];
    if ((b - a).cross(c - a).squaredNorm() == 0) ++facts.degenerate_triangles;
    facts.volume += a.dot(b.cross(c)) / 6;
  }
  if (facts.manifold()) {
    const auto used = static_cast<std::int64_t>(facts.vertices - facts.unused_vertices);
    const std::int64_t euler = used - static_cast<std::int64_t>(edges) + static_cast<std::int64_t>(facts.triangles);
    facts.genus = static_cast<int>((2 * static_cast<std::int64_t>(facts.components) - euler) / 2);
  }
  return facts;
}

std::string broken_promise(const MeshFacts& facts, int genus) {
  const auto counted = [](std::size_t count, const char* what) { return std::to_string(count) + " " + what; };
  if (facts.triangles == 0) return "has no triangles";
  if (facts.open_edges > 0) return "is not closed: " + counted(facts.open_edges, "open edges");
  if (facts.non_manifold_edges > 0)
    return "is not manifold: " + counted(facts.non_manifold_edges, "edges with 3 triangles or more");
  if (facts.bow_tie_vertices > 0) return "is not manifold: " + counted(facts.bow_tie_vertices, "bow-tie vertices");
  if (facts.inconsistent_edges > 0) return "has " + counted(facts.inconsistent_edges, "edges run twice the same way");
  if (facts.repeated_positions > 0) return "has " + counted(facts.repeated_positions, "vertices on top of others");
  if (facts.unused_vertices > 0) return "has " + counted(facts.unused_vertices, "vertices that no triangle uses");
  if (facts.degenerate_triangles > 0) return "has " + counted(facts.degenerate_triangles, "triangles without area");
  if (facts.components != 1) return "has " + counted(facts.components, "components instead of one");
  if (facts.genus != genus) return "has genus " + std::to_string(facts.genus) + " instead of " + std::to_string(genus);
  if (facts.volume <= 0) return "is inside out";
  return {};
}

}  // namespace cagewright::testdata
