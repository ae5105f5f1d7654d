// SPDX-License-Identifier: BSD-3-Clause
#include "host/tests/models/same_cage.h"

#include <algorithm>
#include <cstdio>

namespace cagewright::host {
namespace {

std::string sizes(const Surface& surface) {
  return std::to_string(surface.vertices.size()) + " vertices and " + std::to_string(surface.triangles.size()) +
         " triangles";
}

std::string apart(std::size_t vertex, double distance, double tolerance) {
  std::array<char, 120> text;
  std::snprintf(text.data(), text.size(), "vertex %zu is %.3g away, more than %.3g", vertex, distance, tolerance);
  return text.data();
}

// `surface` with vertex i renumbered to `new_index[i]`, each triangle from its smallest vertex on, in sorted order.
std::vector<std::array<std::size_t, 3>> sorted_triangles(const Surface& surface,
                                                         const std::vector<std::size_t>& new_index) {
  std::vector<std::array<std::size_t, 3>> result;
  for (const auto& [a, b, c] : surface.triangles) {
    std::array<std::size_t, 3> triangle = {new_index[a], new_index[b], new_index[c]};
    std::rotate(triangle.begin(), std::ranges::min_element(triangle), triangle.end());
    result.push_back(triangle);
  }
  std::ranges::sort(result);
  return result;
}

}  // namespace

std::string difference(const Surface& a, const Surface& b, double tolerance) {
  if (a.vertices.size() != b.vertices.size()) return sizes(a) + ", but " + sizes(b);
  for (std::size_t i = 0; i < a.vertices.size(); ++i) {
    const double distance = (a.vertices[i] - b.vertices[i]).norm();
    if (!(distance <= tolerance)) return apart(i, distance, tolerance);
  }
  return a.triangles == b.triangles ? "" : "the triangles are not the same";
}

std::string difference_in_any_order(const Surface& a, const Surface& b, double tolerance) {
  if (a.vertices.size() != b.vertices.size()) return sizes(a) + ", but " + sizes(b);
  std::vector<std::size_t> partner(b.vertices.size(), b.vertices.size());
  for (std::size_t i = 0; i < a.vertices.size(); ++i) {
    const auto nearest = std::ranges::min_element(
        b.vertices, {}, [&](const Eigen::Vector3d& point) { return (point - a.vertices[i]).squaredNorm(); });
    const auto index = static_cast<std::size_t>(nearest - b.vertices.begin());
    const double distance = (*nearest - a.vertices[i]).norm();
    if (!(distance <= tolerance)) return apart(i, distance, tolerance);
    if (partner[index] != b.vertices.size()) return "two vertices have the same partner";
    partner[index] = i;
  }
  std::vector<std::size_t> same(a.vertices.size());
  for (std::size_t i = 0; i < same.size(); ++i) same[i] = i;
  return sorted_triangles(a, same) == sorted_triangles(b, partner) ? "" : "the triangles are not the same";
}

}  // namespace cagewright::host
