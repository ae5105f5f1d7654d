// SPDX-License-Identifier: BSD-3-Clause
#include "host/view/window/drawing_order.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>

namespace cagewright::host {
namespace {

using Eigen::Vector3d;

constexpr unsigned kBits = 10;        // of each coordinate
constexpr double kSmallest = 1e-300;  // its inverse, times all cells, is finite

// Two zeros after each bit.
std::uint32_t spread(std::uint32_t bits) {
  std::uint32_t result = 0;
  for (unsigned i = 0; i < kBits; ++i) result |= (bits >> i & 1) << 3 * i;
  return result;
}

std::vector<std::uint32_t> triangles_along_curve(const TriangleMesh& mesh) {
  Eigen::AlignedBox3d box;
  for (std::size_t i = 0; i < mesh.points.size(); i += 3) box.extend(Vector3d(&mesh.points[i]));
  // Halves: the whole of finite numbers need not be finite.
  const Vector3d low = box.isEmpty() ? Vector3d::Zero() : Vector3d(box.min() / 2);
  const Vector3d sides = box.isEmpty() ? Vector3d::Zero() : Vector3d(box.max() / 2 - low);
  const double cells = ((1 << kBits) - 1) / std::max(sides.maxCoeff(), kSmallest);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> places;
  for (std::size_t i = 0; i < mesh.triangle_count(); ++i) {
    const Vector3d corner(&mesh.points[3 * std::size_t{mesh.triangles[3 * i]}]);
    std::uint32_t code = 0;
    for (Eigen::Index k = 0; k < 3; ++k) {
      code |= spread(static_cast<std::uint32_t>(std::min((corner[k] / 2 - low[k]) * cells, 1.0 * ((1 << kBits) - 1))))
              << k;
    }
    places.emplace_back(code, static_cast<std::uint32_t>(i));
  }
  std::sort(places.begin(), places.end());
  std::vector<std::uint32_t> order;
  for (const auto& [code, triangle] : places) order.push_back(triangle);
  return order;
}

}  // namespace

DrawingOrder drawing_order(const TriangleMesh& mesh) {
  constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  DrawingOrder order;
  order.triangles = triangles_along_curve(mesh);
  order.mesh.triangles.reserve(mesh.triangles.size());
  std::vector<std::uint32_t> row_of(mesh.vertex_count(), kNone);
  for (const std::uint32_t triangle : order.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t vertex = mesh.triangles[3 * std::size_t{triangle} + k];
      if (row_of[vertex] == kNone) {
        row_of[vertex] = static_cast<std::uint32_t>(order.vertices.size());
        order.vertices.push_back(vertex);
        const auto first = mesh.points.begin() + 3 * static_cast<std::ptrdiff_t>(vertex);
        order.mesh.points.insert(order.mesh.points.end(), first, first + 3);
      }
      order.mesh.triangles.push_back(row_of[vertex]);
    }
  }
  return order;
}

}  // namespace cagewright::host
