// SPDX-License-Identifier: BSD-3-Clause
#include "core/segment/enclosed.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace cagewright {
namespace {

constexpr std::size_t samples_per_component = 16;

// Generalised winding number round q of all triangles that are not in `part` [van Oosterom & Strackee 1983].
double winding_of_rest(const Segmentation& segmentation, int part, const Vector3& q) {
  double angle = 0;
  for (std::size_t f = 0; f < segmentation.triangle_part.size(); ++f) {
    if (segmentation.triangle_part[f] == part) continue;
    const auto t = segmentation.cut.triangles.row(static_cast<Eigen::Index>(f));
    const Vector3 a = Vector3(segmentation.cut.points.row(t(0))) - q;
    const Vector3 b = Vector3(segmentation.cut.points.row(t(1))) - q;
    const Vector3 c = Vector3(segmentation.cut.points.row(t(2))) - q;
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    angle += 2 * std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  }
  return angle / (4 * std::numbers::pi);
}

Eigen::AlignedBox3d box_of(const Segmentation& segmentation, const std::vector<int>& vertices) {
  Eigen::AlignedBox3d box;
  for (int v : vertices) box.extend(Vector3(segmentation.cut.points.row(v)));
  return box;
}

bool lies_inside_rest(const Segmentation& segmentation, int index) {
  const std::vector<int>& vertices = segmentation.parts[static_cast<std::size_t>(index)].vertices;
  const std::size_t step = std::max<std::size_t>(1, vertices.size() / samples_per_component);
  for (std::size_t i = 0; i < vertices.size(); i += step)
    if (winding_of_rest(segmentation, index, segmentation.cut.points.row(vertices[i])) < 0.5) return false;
  return true;
}

}  // namespace

void mark_enclosed(Segmentation& segmentation) {
  const bool any = std::any_of(segmentation.parts.begin(), segmentation.parts.end(),
                               [](const Part& part) { return part.sections.empty(); });
  if (!any || segmentation.parts.size() < 2) return;
  Eigen::AlignedBox3d box_of_rest;
  std::vector<Eigen::AlignedBox3d> boxes;
  for (const Part& part : segmentation.parts) boxes.push_back(box_of(segmentation, part.vertices));
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    if (!segmentation.parts[i].sections.empty()) continue;
    box_of_rest.setEmpty();
    for (std::size_t j = 0; j < boxes.size(); ++j)
      if (j != i) box_of_rest.extend(boxes[j]);
    segmentation.parts[i].enclosed =
        box_of_rest.contains(boxes[i]) && lies_inside_rest(segmentation, static_cast<int>(i));
  }
}

}  // namespace cagewright
