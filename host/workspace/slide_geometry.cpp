// SPDX-License-Identifier: BSD-3-Clause
#include "host/workspace/slide_geometry.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <cmath>

#include "host/command/command.h"
#include "host/workspace/point_vector.h"

namespace cagewright::host {
namespace {

using Vector = Eigen::Vector3d;

const Point3& middle_of(const std::vector<Point3>& stroke) {
  std::vector<double> lengths(stroke.size(), 0);
  for (std::size_t i = 1; i < stroke.size(); ++i) {
    lengths[i] = lengths[i - 1] + (vector(stroke[i]) - vector(stroke[i - 1])).norm();
  }
  std::size_t middle = 0;
  const auto off = [&](std::size_t i) { return std::abs(lengths[i] - lengths.back() / 2); };
  for (std::size_t i = 1; i < stroke.size(); ++i) {
    if (off(i) < off(middle)) middle = i;
  }
  return stroke[middle];
}

}  // namespace

Point3 normal_of(const Slide::Ellipse& ellipse) {
  return point(vector(ellipse.u).cross(vector(ellipse.v)).stableNormalized());
}

Slide::Ellipse moved(const Slide::Ellipse& ellipse, const Point3& by) {
  return {point(vector(ellipse.center) + vector(by)), ellipse.u, ellipse.v};
}

Slide::Ellipse turned(const Slide::Ellipse& ellipse, const Point3& axis, double angle) {
  const Eigen::AngleAxisd turn(angle, vector(axis).stableNormalized());
  return {ellipse.center, point(turn * vector(ellipse.u)), point(turn * vector(ellipse.v))};
}

Slide::Ellipse scaled(const Slide::Ellipse& ellipse, double along_u, double along_v) {
  return {ellipse.center, point(along_u * vector(ellipse.u)), point(along_v * vector(ellipse.v))};
}

Point3 mirrored(const Point3& at_point, int axis, double at) {
  Point3 result = at_point;
  const auto k = static_cast<std::size_t>(axis);
  result[k] = 2 * at - result[k];
  return result;
}

// u x v of mirrored radii is the mirrored normal turned round: so one of them is, too.
Slide::Ellipse mirrored(const Slide::Ellipse& ellipse, int axis, double at) {
  return {mirrored(ellipse.center, axis, at), mirrored(ellipse.u, axis, 0),
          point(-vector(mirrored(ellipse.v, axis, 0)))};
}

Slide::PointNormal plane_across(const std::vector<Point3>& stroke, const Point3& line_of_sight) {
  const Vector sight = vector(line_of_sight).stableNormalized();
  if (stroke.size() < 2 || !sight.allFinite() || sight.isZero()) {
    throw CommandError("a stroke across needs two points and a line of sight: draw a longer one");
  }
  const auto across = [&](const Point3& p) -> Vector { return vector(p) - sight.dot(vector(p)) * sight; };
  Vector mean = Vector::Zero();
  for (const Point3& p : stroke) mean += across(p) / static_cast<double>(stroke.size());
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Point3& p : stroke) spread += (across(p) - mean) * (across(p) - mean).transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(spread);
  const Vector normal = axes.eigenvectors().col(2).cross(sight).stableNormalized();
  if (!spread.allFinite() || !(axes.eigenvalues()[2] > 0) || !normal.allFinite() || normal.isZero()) {
    throw CommandError("the stroke has no direction across the line of sight: draw a longer one");
  }
  return {middle_of(stroke), point(normal)};
}

}  // namespace cagewright::host
