// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include "core/mesh/triangle.h"

namespace cagewright {

// All in floating point; degenerate triangles are allowed. O(1).

// Between two triangles that do not meet; for those that do, something between 0 and the distance of their borders.
double triangle_distance(const Triangle3& s, const Triangle3& t);

// Whether that is less than `distance`; faster where it is.
bool are_nearer_than(const Triangle3& s, const Triangle3& t, double distance);

// The points of two triangles at that distance, by barycentric coordinates.
struct NearestPoints {
  double distance = 0;
  Vector3 on_s, on_t;
};
NearestPoints nearest_points(const Triangle3& s, const Triangle3& t);

// Unit; zero for a triangle without area.
Vector3 unit_normal(const Triangle3& t);

// Whether it is too thin for its normal to be relied on. `box` is its own.
bool is_thin(const Triangle3& t, const Eigen::AlignedBox3d& box);

// All points as near to a triangle's longest edge as its farthest point is: what little more than a thin one fills.
class Capsule {
 public:
  Capsule() = default;
  explicit Capsule(const Triangle3& t);

  // Whether the ball is farther than `distance` from it; rounding only ever denies.
  bool parts_ball(const Vector3& center, double radius, double distance) const;

 private:
  Vector3 begin_ = Vector3::Zero(), along_ = Vector3::Zero();  // the edge
  double radius_ = 0;
};

// The plane of a triangle and those through its edges across it: what lies beyond one of them by more than a distance
// is farther than that from the triangle. Round a thin one, the capsule.
class Prism {
 public:
  // `box`: of t.
  Prism(const Triangle3& t, const Eigen::AlignedBox3d& box);

  bool parts_ball(const Vector3& center, double distance) const;
  bool parts(const Triangle3& other, double distance) const;

 private:
  bool is_thin_;
  Capsule capsule_;  // of a thin one
  Vector3 normal_;
  double offset_ = 0;
  std::array<Vector3, 3> sides_;  // unit, outward
  std::array<double, 3> side_offsets_{};
};

// Whether the plane of t, of unit normal n, parts the two by more than `distance`.
bool plane_parts(const Triangle3& t, const Vector3& n, const Triangle3& other, double distance);

}  // namespace cagewright
