// SPDX-License-Identifier: BSD-3-Clause
#include "host/view/window/projection.h"

#include <vtkCamera.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace cagewright::host {
namespace {

constexpr double kDesignDpi = 72;

}  // namespace

Projection::Projection(vtkRenderer& renderer) {
  vtkCamera* camera = renderer.GetActiveCamera();
  eye = Eigen::Vector3d(camera->GetPosition());
  focal_point = Eigen::Vector3d(camera->GetFocalPoint());
  forward = (focal_point - eye).normalized();
  right = forward.cross(Eigen::Vector3d(camera->GetViewUp())).normalized();
  up = right.cross(forward);
  const int* corner = renderer.GetOrigin();
  origin = {static_cast<double>(corner[0]), static_cast<double>(corner[1])};
  const int* pixels = renderer.GetSize();
  size = {std::max(1.0, static_cast<double>(pixels[0])), std::max(1.0, static_cast<double>(pixels[1]))};
  is_orthographic = camera->GetParallelProjection() != 0;
  half_height =
      is_orthographic ? camera->GetParallelScale() : std::tan(camera->GetViewAngle() * std::numbers::pi / 360);
  near_depth = camera->GetClippingRange()[0];
}

double Projection::pixel_at_depth(double depth) const {
  constexpr double kNearest = 1e-9;  // of the distance to the focal point: behind the eye nothing has a size
  const double nearest = kNearest * (focal_point - eye).norm();
  return 2 * half_height / size[1] * (is_orthographic ? 1 : std::max(depth, nearest));
}

double Projection::pixel_at(const Eigen::Vector3d& point) const { return pixel_at_depth((point - eye).dot(forward)); }

Projection::Seen Projection::see(const Eigen::Vector3d& point) const {
  const Eigen::Vector3d way = point - eye;
  Seen seen;
  seen.depth = way.dot(forward);
  seen.is_visible = is_orthographic || seen.depth > 0;
  const double pixel = pixel_at_depth(seen.depth);
  seen.x = origin[0] + size[0] / 2 + way.dot(right) / pixel;
  seen.y = origin[1] + size[1] / 2 + way.dot(up) / pixel;
  return seen;
}

SightLine Projection::sight_line(double x, double y) const {
  const Eigen::Vector3d aside =
      2 * half_height / size[1] * ((x - origin[0] - size[0] / 2) * right + (y - origin[1] - size[1] / 2) * up);
  if (is_orthographic) {
    return {eye + aside + std::min(0.0, near_depth) * forward, forward};
  }
  return {eye, (forward + aside).normalized()};
}

double pixel_ratio(vtkRenderer& renderer) {
  vtkRenderWindow* window = renderer.GetRenderWindow();
  return window == nullptr ? 1 : std::max(1.0, window->GetDPI() / kDesignDpi);
}

}  // namespace cagewright::host
