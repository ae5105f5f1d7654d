// SPDX-License-Identifier: BSD-3-Clause
#include "host/workspace/tilted_plane.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "host/plugin_client/plugin_error.h"
#include "host/workspace/point_vector.h"
#include "host/workspace/slide_geometry.h"

namespace cagewright::host {
namespace {

using Vector = Eigen::Vector3d;

constexpr double too_long = 2.5, long_enough = 1.5;  // of a loop, over the stroke
constexpr double shortest = 0.5;                     // a shorter loop is of a bump, or of another limb
constexpr int steps = 3;                             // each way
constexpr double step = 10 * std::numbers::pi / 180;

struct Tilt {
  int about_sight, about_stroke;
  int size() const { return about_sight * about_sight + about_stroke * about_stroke; }
};

// The least first.
std::vector<Tilt> tilts() {
  std::vector<Tilt> all;
  for (int i = -steps; i <= steps; ++i)
    for (int j = -steps; j <= steps; ++j)
      if (i != 0 || j != 0) all.push_back({i, j});
  std::stable_sort(all.begin(), all.end(), [](const Tilt& a, const Tilt& b) { return a.size() < b.size(); });
  return all;
}

double extent(const Slide::Ellipse& slide, const Vector& direction) {
  return 2 * std::hypot(vector(slide.u).dot(direction), vector(slide.v).dot(direction));
}

// Between two unit normals.
double angle_between(const Vector& a, const Vector& b) { return std::atan2(a.cross(b).norm(), std::abs(a.dot(b))); }

}  // namespace

TiltedPlane tilted_plane(const std::vector<Point3>& stroke, const Point3& line_of_sight, const FitPlane& fit) {
  const Slide::PointNormal plane = plane_across(stroke, line_of_sight);
  const Vector drawn = vector(stroke.back()) - vector(stroke.front());
  const double length = drawn.norm();
  if (!(length > 0)) return {plane, 0};
  const Vector direction = drawn / length, sight = vector(line_of_sight).stableNormalized();
  if (!(extent(fit(plane), direction) > too_long * length)) return {plane, 0};
  for (const Tilt& tilt : tilts()) {
    const Vector normal = Eigen::AngleAxisd(tilt.about_sight * step, sight) *
                          (Eigen::AngleAxisd(tilt.about_stroke * step, direction) * vector(plane.normal));
    const Slide::PointNormal tilted{plane.point, point(normal)};
    try {
      const double share = extent(fit(tilted), direction) / length;
      if (share >= shortest && share <= long_enough) return {tilted, angle_between(normal, vector(plane.normal))};
    } catch (const PluginError& error) {
      if (blame(error.status()) != Blame::slides) throw;
      // No loop there: another tilt may have one.
    }
  }
  return {plane, 0};
}

}  // namespace cagewright::host
