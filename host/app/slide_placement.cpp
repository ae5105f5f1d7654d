// SPDX-License-Identifier: BSD-3-Clause
#include "host/app/slide_placement.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace cagewright::host {
namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double gimbal_lock = 1 - 1e-12;  // sine of the angle about y

Eigen::Vector3d vector(const Point3& p) { return {p[0], p[1], p[2]}; }
Point3 point(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

}  // namespace

SlidePlacement placement_of(const Slide::Ellipse& ellipse) {
  SlidePlacement placement;
  placement.translate = ellipse.center;
  const Eigen::Vector3d u = vector(ellipse.u), v = vector(ellipse.v);
  placement.radius_u = u.norm();
  placement.radius_v = v.norm();
  Eigen::Matrix3d r;  // columns: u, v, normal
  r.col(0) = u.normalized();
  r.col(2) = u.cross(v).normalized();
  r.col(1) = r.col(2).cross(r.col(0));
  // r = Rz Ry Rx.
  const double sine = std::clamp(-r(2, 0), -1.0, 1.0);
  placement.rotate[1] = std::asin(sine) / degree;
  if (std::abs(sine) < gimbal_lock) {
    placement.rotate[0] = std::atan2(r(2, 1), r(2, 2)) / degree;
    placement.rotate[2] = std::atan2(r(1, 0), r(0, 0)) / degree;
  } else {
    placement.rotate[2] = std::atan2(-r(0, 1), r(1, 1)) / degree;
  }
  return placement;
}

Slide::Ellipse ellipse_of(const SlidePlacement& placement) {
  using Eigen::AngleAxisd, Eigen::Vector3d;
  const Eigen::Matrix3d r = (AngleAxisd(placement.rotate[2] * degree, Vector3d::UnitZ()) *
                             AngleAxisd(placement.rotate[1] * degree, Vector3d::UnitY()) *
                             AngleAxisd(placement.rotate[0] * degree, Vector3d::UnitX()))
                                .toRotationMatrix();
  return {placement.translate, point(placement.radius_u * r.col(0)), point(placement.radius_v * r.col(1))};
}

}  // namespace cagewright::host
