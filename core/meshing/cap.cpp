// SPDX-License-Identifier: BSD-3-Clause
#include "core/meshing/cap.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "core/mesh/tolerance.h"

namespace cagewright {

std::array<Vector3, 4> cap_of(const Points& points, const Part& part, const SectionFrame& section,
                              const Vector3& into) {
  const double infinity = std::numeric_limits<double>::infinity();
  double height = 0;
  for (int v : part.vertices) height = std::max(height, into.dot(Vector3(points.row(v)) - section.center));
  const double half_p = section.p.norm(), half_q = section.q.norm();
  height = std::max(height, tolerance::least_cap * std::min(half_p, half_q));
  const Vector3 p = section.p / half_p, q = section.q / half_q;
  Vector2 low(infinity, infinity), high(-infinity, -infinity);
  for (int v : part.vertices) {
    const Vector3 offset = Vector3(points.row(v)) - section.center;
    if (into.dot(offset) < (0.5 - tolerance::tie) * height) continue;
    const Vector2 flat(p.dot(offset), q.dot(offset));
    low = low.cwiseMin(flat);
    high = high.cwiseMax(flat);
  }
  if (!(low.x() <= high.x())) low = high = Vector2::Zero();
  const Vector2 middle = (low + high) / 2;
  const Vector2 half = ((high - low) / 2).cwiseMax(tolerance::least_cap * Vector2(half_p, half_q));
  const Vector3 center = section.center + height * into + middle.x() * p + middle.y() * q;
  return SectionFrame{center, section.normal, half.x() * p, half.y() * q, section.x}.corners();
}

std::array<Vector3, 8> box_of(const Points& points, const Part& part) {
  Eigen::AlignedBox3d box;
  for (int v : part.vertices) box.extend(Vector3(points.row(v)));
  const Vector3 missing = Vector3::Constant(tolerance::least_thickness * box.diagonal().norm()) - box.sizes();
  box.min() -= missing.cwiseMax(0) / 2;
  box.max() += missing.cwiseMax(0) / 2;
  std::array<Vector3, 8> corners;
  for (int i = 0; i < 8; ++i)
    corners[static_cast<std::size_t>(i)] = box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(i));
  return corners;
}

const std::array<std::array<int, 3>, 12> box_triangles = {{{0, 2, 3},
                                                           {0, 3, 1},
                                                           {4, 5, 7},
                                                           {4, 7, 6},
                                                           {0, 1, 5},
                                                           {0, 5, 4},
                                                           {2, 6, 7},
                                                           {2, 7, 3},
                                                           {0, 4, 6},
                                                           {0, 6, 2},
                                                           {1, 3, 7},
                                                           {1, 7, 5}}};

}  // namespace cagewright
