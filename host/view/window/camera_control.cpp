// SPDX-License-Identifier: BSD-3-Clause
#include "host/view/window/camera_control.h"

#include <vtkCamera.h>
#include <vtkRenderer.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "host/view/picture.h"
#include "host/view/window/projection.h"

namespace cagewright::host {
namespace {

using Eigen::Vector3d;

constexpr double kFarthest = 1e15;          // units of the scene
constexpr double kRadiansPerPixel = 0.006;  // tumble; a window's width is about one turn
constexpr double kDollyPerPixel = 0.005;    // of the distance, exponentially
constexpr double kZoomPerStep = 0.15;       // likewise
constexpr double kMargin = 1.06;            // round what is framed
constexpr double kNearOverFar = 2e-4;       // of the clipping range: what 24 bits of depth bear
constexpr double kClippingSlack = 0.02;     // of the content's depth
constexpr double kNearestDistance = 1e-9, kFarthestDistance = 1e12;

double tangent(vtkCamera& camera) { return std::tan(camera.GetViewAngle() * std::numbers::pi / 360); }

struct Place {
  Vector3d eye, focal_point, up;
};

Place place_of(vtkRenderer& renderer) {
  const Projection now(renderer);
  return {now.eye, now.focal_point, now.up};
}

// Sets the parallel scale, too, so that both projections show the same at the centre.
// Not beyond what can be drawn: numbers are floats there, and there would be no way back.
void put(vtkRenderer& renderer, const Place& place) {
  const double farthest = std::max(place.focal_point.cwiseAbs().maxCoeff(), place.eye.cwiseAbs().maxCoeff());
  if (!place.focal_point.allFinite() || !place.eye.allFinite() || !place.up.allFinite() || farthest > kFarthest) return;
  vtkCamera* camera = renderer.GetActiveCamera();
  camera->SetFocalPoint(place.focal_point.data());
  camera->SetPosition(place.eye.data());
  camera->SetViewUp(place.up.data());
  camera->SetParallelScale((place.eye - place.focal_point).norm() * tangent(*camera));
}

void turn_about(Place& place, const Vector3d& axis, double radians) {
  const Eigen::AngleAxisd turn(radians, axis);
  place.eye = place.focal_point + turn * (place.eye - place.focal_point);
  place.up = turn * place.up;
}

// `factor` of the distance; what is at `anchor`, in the plane of the centre, stays where it is on the screen.
void approach(vtkRenderer& renderer, double factor, const Vector3d& anchor) {
  Place place = place_of(renderer);
  const Vector3d way = place.eye - place.focal_point;
  const double distance = std::clamp(way.norm() * factor, kNearestDistance, kFarthestDistance);
  factor = distance / way.norm();
  place.focal_point = anchor + factor * (place.focal_point - anchor);
  place.eye = place.focal_point + factor * way;
  put(renderer, place);
}

// Towards the viewer and up, for a world whose up is y.
std::pair<Vector3d, Vector3d> directions_of(CameraControl::Axis axis) {
  switch (axis) {
    case CameraControl::Axis::front:
      return {Vector3d::UnitZ(), Vector3d::UnitY()};
    case CameraControl::Axis::back:
      return {-Vector3d::UnitZ(), Vector3d::UnitY()};
    case CameraControl::Axis::left:
      return {-Vector3d::UnitX(), Vector3d::UnitY()};
    case CameraControl::Axis::right:
      return {Vector3d::UnitX(), Vector3d::UnitY()};
    case CameraControl::Axis::top:
      return {Vector3d::UnitY(), -Vector3d::UnitZ()};
    case CameraControl::Axis::bottom:
      return {-Vector3d::UnitY(), Vector3d::UnitZ()};
    case CameraControl::Axis::perspective:
      break;
  }
  return {to_vector(View{}.toward_viewer).normalized(), Vector3d::UnitY()};
}

}  // namespace

CameraControl::CameraControl(vtkRenderer& renderer) : renderer_(renderer) {
  put(renderer_, {Vector3d(0, 0, 5), Vector3d::Zero(), Vector3d::UnitY()});
  look_along(Axis::perspective);
}

void CameraControl::tumble(double dx, double dy) {
  const double step = kRadiansPerPixel / pixel_ratio(renderer_);
  Place place = place_of(renderer_);
  const Vector3d up = to_vector(up_).normalized();
  const Projection now(renderer_);
  // What other code may have rolled is set level again.
  const Vector3d level = now.right - now.right.dot(up) * up;
  const Vector3d right = level.norm() > 1e-6 ? Vector3d(level.normalized()) : now.right;
  place.up = right.cross(now.forward).normalized();
  const bool upside_down = place.up.dot(up) < 0;
  turn_about(place, right, dy * step);
  turn_about(place, up, (upside_down ? dx : -dx) * step);
  put(renderer_, place);
  update_clipping();
}

void CameraControl::track(double dx, double dy) {
  const Projection now(renderer_);
  const Vector3d way = -now.pixel_at(now.focal_point) * (dx * now.right + dy * now.up);
  Place place = place_of(renderer_);
  place.eye += way;
  place.focal_point += way;
  put(renderer_, place);
  update_clipping();
}

void CameraControl::dolly(double pixels) {
  approach(renderer_, std::exp(-kDollyPerPixel / pixel_ratio(renderer_) * pixels), place_of(renderer_).focal_point);
  update_clipping();
}

void CameraControl::zoom_at(double steps, double x, double y) {
  const Projection now(renderer_);
  const SightLine line = now.sight_line(x, y);
  const double along = (now.focal_point - line.origin).dot(now.forward) / line.direction.dot(now.forward);
  approach(renderer_, std::exp(-kZoomPerStep * steps), line.origin + along * line.direction);
  update_clipping();
}

void CameraControl::frame(const std::array<double, 6>& bounds) {
  const Projection now(renderer_);
  const double vertical = tangent(*renderer_.GetActiveCamera());
  const double horizontal = vertical * now.size[0] / now.size[1];
  const Vector3d center((bounds[0] + bounds[1]) / 2, (bounds[2] + bounds[3]) / 2, (bounds[4] + bounds[5]) / 2);
  double distance = 0;
  for (std::size_t i = 0; i < 8; ++i) {
    const Vector3d corner(bounds[i & 1], bounds[2 + ((i >> 1) & 1)], bounds[4 + (i >> 2)]);
    const Vector3d way = corner - center;
    const double fill = std::max(std::abs(way.dot(now.right)) / horizontal, std::abs(way.dot(now.up)) / vertical);
    distance = std::max(distance, kMargin * fill - (now.is_orthographic ? 0 : way.dot(now.forward)));
  }
  if (!(distance > 0) || !std::isfinite(distance)) {
    distance = (now.eye - now.focal_point).norm();  // one point: it is only put into the middle
  }
  put(renderer_, {center - distance * now.forward, center, now.up});
  update_clipping();
}

void CameraControl::look_along(Axis axis) {
  const auto turn = Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitY(), to_vector(up_));
  const auto [toward_viewer, up] = directions_of(axis);
  Place place = place_of(renderer_);
  const double distance = (place.eye - place.focal_point).norm();
  const Vector3d forward = -(turn * toward_viewer);
  const Vector3d right = forward.cross(turn * up).normalized();
  put(renderer_, {place.focal_point - distance * forward, place.focal_point, right.cross(forward)});
  update_clipping();
}

void CameraControl::look_from(const Point3& toward_viewer) {
  Place place = place_of(renderer_);
  const double distance = (place.eye - place.focal_point).norm();
  const Vector3d forward = -to_vector(toward_viewer);
  const Vector3d level = forward.cross(to_vector(up_));
  // Straight from above or below any right is level.
  const Vector3d right = level.norm() > 1e-6 ? Vector3d(level.normalized()) : Projection(renderer_).right;
  put(renderer_, {place.focal_point - distance * forward, place.focal_point, right.cross(forward).normalized()});
  update_clipping();
}

void CameraControl::set_orthographic(bool orthographic) {
  renderer_.GetActiveCamera()->SetParallelProjection(orthographic ? 1 : 0);
  update_clipping();
}

bool CameraControl::is_orthographic() const { return renderer_.GetActiveCamera()->GetParallelProjection() != 0; }

void CameraControl::turn(double degrees) {
  Place place = place_of(renderer_);
  turn_about(place, to_vector(up_).normalized(), degrees * std::numbers::pi / 180);
  put(renderer_, place);
  update_clipping();
}

void CameraControl::set_up(const Point3& up) {
  const Vector3d before = to_vector(up_);
  up_ = up;
  Place place = place_of(renderer_);
  const auto turn = Eigen::Quaterniond::FromTwoVectors(before, to_vector(up_));
  place.eye = place.focal_point + turn * (place.eye - place.focal_point);
  place.up = turn * place.up;
  put(renderer_, place);
  update_clipping();
}

// VTK's own puts nothing behind the eye into an orthographic range, and cuts more off near the eye than it must.
void CameraControl::update_clipping() {
  double bounds[6];
  renderer_.ComputeVisiblePropBounds(bounds);
  const Projection now(renderer_);
  const double distance = (now.focal_point - now.eye).norm();
  double nearest = distance / 2, farthest = 2 * distance;
  if (bounds[0] <= bounds[1]) {
    nearest = std::numeric_limits<double>::infinity();
    farthest = -nearest;
    for (std::size_t i = 0; i < 8; ++i) {
      const Vector3d corner(bounds[i & 1], bounds[2 + ((i >> 1) & 1)], bounds[4 + (i >> 2)]);
      const double depth = (corner - now.eye).dot(now.forward);
      nearest = std::min(nearest, depth);
      farthest = std::max(farthest, depth);
    }
  }
  const double slack = std::max(kClippingSlack * (farthest - nearest), 1e-3 * distance);
  const double range_near = nearest - slack / 2, range_far = farthest + slack / 2;  // the least that will do
  nearest -= slack;
  farthest += slack;
  if (!now.is_orthographic) {
    farthest = std::max(farthest, distance * 1e-3);
    nearest = std::max(nearest, kNearOverFar * farthest);
  }
  // A range that will do stays: what hangs on the camera need not be drawn again for every small movement.
  const double* range = renderer_.GetActiveCamera()->GetClippingRange();
  const bool holds_all = range[0] <= std::max(range_near, nearest) && range[1] >= range_far;
  const bool is_tight = range[1] - range[0] <= 1.1 * (farthest - nearest) && (now.is_orthographic || range[0] > 0);
  if (holds_all && is_tight) return;
  renderer_.GetActiveCamera()->SetClippingRange(nearest, farthest);
}

}  // namespace cagewright::host
