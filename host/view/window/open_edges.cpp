// SPDX-License-Identifier: BSD-3-Clause
#include "host/view/window/open_edges.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>

namespace cagewright::host {
namespace {

Point point_of(const TriangleMesh& mesh, std::uint32_t vertex) {
  const double* p = &mesh.points[3 * std::size_t{vertex}];
  return {p[0], p[1], p[2]};
}

// Of each vertex the first of those at its point: files of triangle soups have a vertex for each corner.
std::vector<std::uint32_t> merged_vertices(const TriangleMesh& mesh) {
  std::vector<std::uint32_t> order(mesh.vertex_count()), merged(order.size());
  std::iota(order.begin(), order.end(), 0U);
  std::ranges::sort(order, {}, [&](std::uint32_t vertex) { return std::pair(point_of(mesh, vertex), vertex); });
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool is_same = i > 0 && point_of(mesh, order[i]) == point_of(mesh, order[i - 1]);
    merged[order[i]] = is_same ? merged[order[i - 1]] : order[i];
  }
  return merged;
}

}  // namespace

std::vector<std::vector<Point>> open_edges(const TriangleMesh& mesh, std::size_t most) {
  const std::vector<std::uint32_t> merged = merged_vertices(mesh);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  edges.reserve(mesh.triangles.size());
  for (std::size_t i = 0; i + 2 < mesh.triangles.size(); i += 3) {
    const std::array<std::uint32_t, 3> corners = {merged[mesh.triangles[i]], merged[mesh.triangles[i + 1]],
                                                  merged[mesh.triangles[i + 2]]};
    if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) continue;
    for (std::size_t k = 0; k < 3; ++k) edges.push_back(std::minmax({corners[k], corners[(k + 1) % 3]}));
  }
  std::ranges::sort(edges);
  std::vector<std::vector<Point>> open;
  for (std::size_t i = 0, next = 0; i < edges.size() && open.size() < most; i = next) {
    while (next < edges.size() && edges[next] == edges[i]) ++next;
    const auto [a, b] = edges[i];
    if (next == i + 1) open.push_back({point_of(mesh, a), point_of(mesh, b)});
  }
  return open;
}

}  // namespace cagewright::host
