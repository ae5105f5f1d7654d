// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "core/mesh/types.h"

namespace cagewright {

// Coordinates in a plane: (e1, e2, normal) is orthonormal and right-handed.
struct PlaneFrame {
  Vector3 origin, normal, e1, e2;

  // `normal_direction` of any length > 0.
  PlaneFrame(const Vector3& plane_origin, const Vector3& normal_direction)
      : origin(plane_origin), normal(normal_direction.stableNormalized()) {
    e1 = normal.unitOrthogonal();
    e2 = normal.cross(e1);
  }
  Vector2 to_plane(const Vector3& point) const { return {e1.dot(point - origin), e2.dot(point - origin)}; }
  std::vector<Vector2> to_plane(const Points& points) const {
    std::vector<Vector2> flat(static_cast<std::size_t>(points.rows()));
    for (std::size_t i = 0; i < flat.size(); ++i) flat[i] = to_plane(Vector3(points.row(static_cast<Eigen::Index>(i))));
    return flat;
  }
  Vector3 to_space(const Vector2& point) const { return origin + point.x() * e1 + point.y() * e2; }
};

}  // namespace cagewright
