// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <array>

#include "core/mesh/types.h"

namespace cagewright {

using Triangle3 = std::array<Vector3, 3>;

// The corners of a mesh's triangle.
inline Triangle3 triangle_of(const IndexedMesh& mesh, Eigen::Index t) {
  const auto corners = mesh.triangles.row(t);
  return {mesh.points.row(corners(0)), mesh.points.row(corners(1)), mesh.points.row(corners(2))};
}

inline Vector3 at_barycentric(const Triangle3& t, const Vector3& weights) {
  return weights[0] * t[0] + weights[1] * t[1] + weights[2] * t[2];
}

// Barycentric coordinates of the point on edge i, from corner i, at `share` of the way to the next corner.
inline Vector3 on_edge(std::size_t i, double share) {
  Vector3 weights = Vector3::Zero();
  weights[static_cast<Eigen::Index>(i)] = 1 - share;
  weights[static_cast<Eigen::Index>((i + 1) % 3)] = share;
  return weights;
}

// Whether the foot of the perpendicular from p is inside; then its barycentric coordinates. Never of a triangle without
// area. In floating point. O(1).
inline bool foot_inside(const Vector3& p, const Triangle3& t, Vector3& weights) {
  const Vector3 normal = (t[1] - t[0]).cross(t[2] - t[0]);
  const double squared = normal.squaredNorm();
  if (!(squared > 0)) return false;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector3& a = t[(i + 1) % 3];
    weights[static_cast<Eigen::Index>(i)] = normal.dot((t[(i + 2) % 3] - a).cross(p - a)) / squared;
  }
  return weights.minCoeff() >= 0;
}

// Barycentric coordinates of the point of t that is nearest to p. In floating point; t may be degenerate. O(1).
Vector3 nearest_on_triangle(const Vector3& p, const Triangle3& t);

}  // namespace cagewright
