// SPDX-License-Identifier: BSD-3-Clause
#include "testdata/tests/plane_loops.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>

namespace cagewright::testdata {
// A vertex in the plane counts as above it, so that every loop runs along edges with one end on either side. With
// triangles counter-clockwise, each crossed triangle has one edge that goes down (above, below) and one that goes up.
std::vector<PlaneLoop> cut_by_plane(const TriangleMesh& mesh, const Eigen::Vector3d& point,
                                    const Eigen::Vector3d& normal) {
  std::vector<double> height;
  for (const Eigen::Vector3d& v : mesh.vertices) height.push_back((v - point).dot(normal));
  const auto above = [&](std::uint32_t v) { return height[v] >= 0; };

  std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> by_entry;  // (above, below) of the edge that goes up
  std::map<std::size_t, std::pair<std::uint32_t, std::uint32_t>> exit;      // (above, below) of the edge that goes down
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = mesh.triangles[t][k];
      const std::uint32_t b = mesh.triangles[t][(k + 1) % 3];
      if (!above(a) && above(b)) by_entry[{b, a}] = t;
      if (above(a) && !above(b)) exit[t] = {a, b};
    }
  }
  std::vector<PlaneLoop> loops;
  while (!exit.empty()) {
    PlaneLoop& loop = loops.emplace_back();
    for (auto at = exit.begin(); at != exit.end();) {
      const auto [a, b] = at->second;
      const double weight = height[a] / (height[a] - height[b]);
      loop.points.emplace_back(mesh.vertices[a] + weight * (mesh.vertices[b] - mesh.vertices[a]));
      loop.triangles.push_back(at->first);
      loop.edges.push_back({std::min(a, b), std::max(a, b)});
      exit.erase(at);
      at = exit.find(by_entry.at({a, b}));
    }
    std::ranges::sort(loop.triangles);
    std::ranges::sort(loop.edges);
  }
  return loops;
}

bool encloses(const PlaneLoop& loop, const Eigen::Vector3d& point, const Eigen::Vector3d& normal) {
  double turned = 0;
  for (std::size_t i = 0; i < loop.points.size(); ++i) {
    const Eigen::Vector3d a = loop.points[i] - point;
    const Eigen::Vector3d b = loop.points[(i + 1) % loop.points.size()] - point;
    turned += std::atan2(a.cross(b).dot(normal), a.dot(b));
  }
  return std::abs(turned) > 3;
}

}  // namespace cagewright::testdata
