// SPDX-License-Identifier: BSD-3-Clause
#include "host/view/window/handle_drag.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace cagewright::host {
namespace {

using Eigen::Vector3d;
using Mode = SlideHandles::Mode;

constexpr double kLeverage = 10;    // how much farther than on the screen things may move
constexpr double kEdgeOn = 0.2;     // cosine between the line of sight and a ring's axis
constexpr double kParallel = 1e-8;  // squared sine below which lines have no nearest points
constexpr double kLeastFactor = 1e-3;
constexpr double kTurnStep = std::numbers::pi / 12, kScaleStep = 0.1;

double within(double value, double limit) { return std::clamp(value, -limit, limit); }

Point3 sum(const Point3& point, const Vector3d& way) { return to_point(to_vector(point) + way); }

Point3 scaled(const Point3& radius, double factor) { return to_point(factor * to_vector(radius)); }

}  // namespace

std::optional<HandleFrame> handle_frame(const Slide::Ellipse& ellipse) {
  const Vector3d u = to_vector(ellipse.u).stableNormalized(), v = to_vector(ellipse.v).stableNormalized();
  const Vector3d normal = u.cross(v).stableNormalized();
  HandleFrame frame{to_vector(ellipse.center), {}};
  frame.axes << u, normal.cross(u), normal;
  const bool is_sound = frame.center.allFinite() && std::abs(frame.axes.determinant() - 1) < 1e-6;
  return is_sound ? std::optional(frame) : std::nullopt;
}

HandleDrag::HandleDrag(const Begin& begin, const Projection& projection)
    : begin_(begin),
      projection_(projection),
      linear_(begin.to_scene.topLeftCorner<3, 3>()),
      from_scene_(begin.to_scene.inverse()),
      center_(transformed(begin.to_scene, begin.frame.center)) {
  const bool is_axis = begin_.way == HandleWay::u || begin_.way == HandleWay::v || begin_.way == HandleWay::normal;
  const auto k = is_axis ? static_cast<Eigen::Index>(begin_.way) : 2;
  axis_in_mesh_ = begin_.frame.axes.col(k);
  axis_ = (linear_ * axis_in_mesh_).normalized();
  // Planes stay planes under any transform, but what is across them does not stay so. A mirrored one turns as it looks.
  const Vector3d a = begin_.frame.axes.col((k + 1) % 3), b = begin_.frame.axes.col((k + 2) % 3);
  normal_ =
      begin_.way == HandleWay::view ? projection_.forward : Vector3d((linear_ * a).cross(linear_ * b).normalized());
  const auto seen = projection_.see(center_);
  is_edge_on_ = std::abs(projection_.sight_line(seen.x, seen.y).direction.dot(normal_)) < kEdgeOn;
  begin_on_axis_ = on_axis(begin_.x, begin_.y);
  begin_on_plane_ = on_plane(begin_.x, begin_.y);
  last_angle_ = angle_at(begin_.x, begin_.y).value_or(0);
}

double HandleDrag::handle_length() const { return begin_.length * projection_.pixel_at(center_); }

double HandleDrag::farthest(double x, double y) const {
  return kLeverage * std::hypot(x - begin_.x, y - begin_.y) * projection_.pixel_at(center_);
}

// Where along the axis, from the centre, it is nearest to the line of sight.
std::optional<double> HandleDrag::on_axis(double x, double y) const {
  const SightLine line = projection_.sight_line(x, y);
  const double cosine = axis_.dot(line.direction), squared_sine = 1 - cosine * cosine;
  if (squared_sine < kParallel) return std::nullopt;
  const Vector3d way = center_ - line.origin;
  const double along = (cosine * way.dot(line.direction) - way.dot(axis_)) / squared_sine;
  const double depth = way.dot(line.direction) + along * cosine;
  return depth > 0 || projection_.is_orthographic ? std::optional(along) : std::nullopt;
}

std::optional<Vector3d> HandleDrag::on_plane(double x, double y) const {
  const SightLine line = projection_.sight_line(x, y);
  const double cosine = normal_.dot(line.direction);
  if (cosine == 0) return std::nullopt;
  const double depth = normal_.dot(center_ - line.origin) / cosine;
  const bool is_there = std::isfinite(depth) && (depth > 0 || projection_.is_orthographic);
  return is_there ? std::optional<Vector3d>(line.origin + depth * line.direction) : std::nullopt;
}

// About the axis, in the mesh's space, from the next axis of the frame.
std::optional<double> HandleDrag::angle_at(double x, double y) const {
  const auto point = on_plane(x, y);
  if (!point) return std::nullopt;
  const auto k = begin_.way == HandleWay::u ? 0 : begin_.way == HandleWay::v ? 1 : 2;
  const Vector3d way = transformed(from_scene_, *point) - begin_.frame.center;
  return std::atan2(way.dot(begin_.frame.axes.col((k + 2) % 3)), way.dot(begin_.frame.axes.col((k + 1) % 3)));
}

double HandleDrag::way_along_axis(double x, double y) {
  const auto now = on_axis(x, y);
  if (now && begin_on_axis_) way_ = *now - *begin_on_axis_;
  return within(way_, farthest(x, y));
}

Vector3d HandleDrag::way_in_plane(double x, double y) {
  const auto now = on_plane(x, y);
  if (now && begin_on_plane_) way_in_plane_ = *now - *begin_on_plane_;
  const double length = way_in_plane_.norm(), limit = farthest(x, y);
  return length > limit ? Vector3d(way_in_plane_ * (limit / length)) : way_in_plane_;
}

double HandleDrag::angle_turned(double x, double y) {
  if (is_edge_on_) {
    // The near side of the ring follows the mouse: pixels along it over its radius.
    const Vector3d near_side = normal_.cross(-projection_.forward).normalized();
    const double pixels =
        (x - begin_.x) * near_side.dot(projection_.right) + (y - begin_.y) * near_side.dot(projection_.up);
    return pixels / begin_.length;
  }
  if (const auto now = angle_at(x, y)) {
    turned_ += std::remainder(*now - last_angle_, 2 * std::numbers::pi);
    last_angle_ = *now;
  }
  return turned_;
}

double HandleDrag::factor(double x, double y) {
  const double grown = begin_.way == HandleWay::plane ? (x - begin_.x + y - begin_.y) / begin_.length
                                                      : way_along_axis(x, y) / handle_length();
  return std::max(kLeastFactor, 1 + grown);
}

SlideEllipses HandleDrag::to(double x, double y, bool snap) {
  SlideEllipses slides = begin_.slides;
  Vector3d way = Vector3d::Zero();
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  double u_factor = 1, v_factor = 1;
  if (begin_.mode == Mode::move) {
    const bool is_plane = begin_.way == HandleWay::plane || begin_.way == HandleWay::view;
    const Vector3d in_scene = is_plane ? way_in_plane(x, y) : Vector3d(way_along_axis(x, y) * axis_);
    way = from_scene_.topLeftCorner<3, 3>() * in_scene;
  } else if (begin_.mode == Mode::turn) {
    double angle = angle_turned(x, y);
    if (snap) angle = kTurnStep * std::round(angle / kTurnStep);
    turn = Eigen::AngleAxisd(angle, axis_in_mesh_).toRotationMatrix();
  } else if (begin_.mode == Mode::scale) {
    double by = factor(x, y);
    if (snap) by = std::max(kScaleStep, kScaleStep * std::round(by / kScaleStep));
    u_factor = begin_.way == HandleWay::v ? 1 : by;
    v_factor = begin_.way == HandleWay::u ? 1 : by;
  }
  for (auto& [id, ellipse] : slides) {
    ellipse.center = sum(ellipse.center, way);
    ellipse.u = scaled(to_point(turn * to_vector(ellipse.u)), u_factor);
    ellipse.v = scaled(to_point(turn * to_vector(ellipse.v)), v_factor);
  }
  return slides;
}

}  // namespace cagewright::host
