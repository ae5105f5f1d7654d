// SPDX-License-Identifier: BSD-3-Clause
#include "host/workspace/tilted_plane.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <new>
#include <numbers>
#include <string>

#include "host/plugin_client/plugin_error.h"
#include "host/workspace/slide_geometry.h"

namespace cagewright::host {
namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double limb = 0.2, body = 1.5, depth = 0.1;  // half lengths along y, y and z
const Point3 sight = {0, 0, -1};

PluginError no_loop(const std::string& sentence) {
  cgw_error_info info = CGW_ERROR_INFO_INIT;
  info.code = CGW_ERROR_SLIDE_NOT_ENCLOSED;
  return {info, sentence};
}

// An arm along x, from x = 0, on a body with x < 0: a plane that reaches the body within the arm's girth runs on along
// it. The plane has no loop where it is nearly along the arm.
class Shoulder {
 public:
  explicit Shoulder(double longest = 100) : longest_(longest) {}

  Slide::Ellipse operator()(const Slide::PointNormal& plane) {
    ++fits;
    const Point3& n = plane.normal;
    if (std::abs(n[1]) > 0.99 * std::abs(n[0])) throw no_loop("no loop");
    const auto x_at = [&](double y) { return plane.point[0] - (y - plane.point[1]) * n[1] / n[0]; };
    const double top = x_at(limb) < 0 ? body : limb, bottom = x_at(-limb) < 0 ? -body : -limb;
    const Point3 from = {x_at(bottom), bottom, 0}, to = {x_at(top), top, 0};
    if (to[1] - from[1] > longest_) throw no_loop("too long for a slide");
    return {{(from[0] + to[0]) / 2, (from[1] + to[1]) / 2, 0},
            {(to[0] - from[0]) / 2, (to[1] - from[1]) / 2, 0},
            {-n[2] * depth, 0, depth}};
  }

  int fits = 0;

 private:
  double longest_;
};

std::vector<Point3> stroke(const Point3& from, const Point3& to) {
  std::vector<Point3> points;
  for (int i = 0; i <= 10; ++i) {
    const double share = i / 10.0;
    points.push_back({from[0] + share * (to[0] - from[0]), from[1] + share * (to[1] - from[1]), depth});
  }
  return points;
}

double tilt_of(const Slide::PointNormal& plane, const std::vector<Point3>& points) {
  const Point3 straight = plane_across(points, sight).normal;
  double dot = 0;
  for (std::size_t i = 0; i < 3; ++i) dot += straight[i] * plane.normal[i];
  return std::acos(std::min(1.0, std::abs(dot))) / degree;
}

const std::vector<Point3> into_the_body = stroke({0.25, 0.2, 0}, {-0.03, -0.18, 0});

TEST(TiltedPlane, OfAStrokeWhosePlaneRunsAlongTheBodyIsTheLeastTiltedThatGoesRoundTheLimb) {
  Shoulder shoulder;
  const auto [plane, tilt] = tilted_plane(into_the_body, sight, std::ref(shoulder));
  EXPECT_EQ(plane.point, plane_across(into_the_body, sight).point);
  EXPECT_NEAR(tilt_of(plane, into_the_body), 10, 1e-6);
  const Slide::Ellipse slide = shoulder(plane);
  EXPECT_LT(2 * std::hypot(slide.u[0], slide.u[1]), 0.6) << "about as long as the stroke";
  EXPECT_NEAR(tilt, 10 * degree, 1e-6);
}

TEST(TiltedPlane, HoldsTheLineOfSightWhereItsLoopIsNotMuchLongerThanTheStroke) {
  Shoulder shoulder;
  for (const auto& points : {stroke({0.5, 0.2, 0}, {0.4, -0.2, 0}), stroke({0.5, 0.1, 0}, {0.5, -0.08, 0})}) {
    const auto [plane, tilt] = tilted_plane(points, sight, std::ref(shoulder));
    EXPECT_EQ(plane.normal, plane_across(points, sight).normal);
    EXPECT_EQ(tilt, 0);
  }
  EXPECT_EQ(shoulder.fits, 2);
}

TEST(TiltedPlane, HoldsTheLineOfSightWhereNoTiltHelps) {
  Shoulder shoulder;
  const std::vector<Point3> on_the_body = stroke({-0.9, 0.2, 0}, {-0.9, -0.2, 0});
  const auto [plane, tilt] = tilted_plane(on_the_body, sight, std::ref(shoulder));
  EXPECT_EQ(plane.normal, plane_across(on_the_body, sight).normal);
  EXPECT_EQ(tilt, 0);
  EXPECT_LE(shoulder.fits, 49);
}

TEST(TiltedPlane, ThrowsWhatThePlaneItselfDoes) {
  Shoulder shoulder(0.4);
  EXPECT_THROW(tilted_plane(into_the_body, sight, std::ref(shoulder)), PluginError);
  EXPECT_EQ(shoulder.fits, 1);
}

TEST(TiltedPlane, TakesNoOtherErrorOfATiltedPlaneForOneWithoutALoop) {
  const auto fails = [](auto failure) {
    return [failure, shoulder = Shoulder()](const Slide::PointNormal& plane) mutable {
      if (shoulder.fits > 0) throw failure;
      return shoulder(plane);
    };
  };
  EXPECT_THROW(tilted_plane(into_the_body, sight, fails(std::bad_alloc())), std::bad_alloc);
  cgw_error_info info = CGW_ERROR_INFO_INIT;
  info.code = CGW_ERROR_OUT_OF_MEMORY;
  EXPECT_THROW(tilted_plane(into_the_body, sight, fails(PluginError(info, "no memory"))), PluginError);
}

}  // namespace
}  // namespace cagewright::host
