// SPDX-License-Identifier: BSD-3-Clause
#include "host/view/window/camera_control.h"

#include <gtest/gtest.h>
#include <vtkCamera.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "host/view/tests/window_fixture.h"

namespace cagewright::host {
namespace {

using Axis = CameraControl::Axis;

Point3 minus(const Point3& a, const Point3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
double dot(const Point3& a, const Point3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Point3 cross(const Point3& a, const Point3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double length(const Point3& a) { return std::sqrt(dot(a, a)); }

class Camera : public Window {
 protected:
  Camera() { view->set_meshes({shown(box_mesh(1))}); }

  Point3 eye() const { return point_of(renderer->GetActiveCamera()->GetPosition()); }
  Point3 center() const { return point_of(renderer->GetActiveCamera()->GetFocalPoint()); }
  Point3 up() const { return point_of(renderer->GetActiveCamera()->GetViewUp()); }
  Point3 forward() const {
    const Point3 way = minus(center(), eye());
    return {way[0] / length(way), way[1] / length(way), way[2] / length(way)};
  }
  Point3 right() const { return cross(forward(), up()); }
  static Point3 point_of(const double* values) { return {values[0], values[1], values[2]}; }
  // The box of what is not background: {left, right, bottom, top} in pixels.
  static std::array<int, 4> extent(const Image& image) {
    std::array<int, 4> box{image.width, -1, image.height, -1};
    for (int i = 0; i < image.width * image.height; ++i) {
      const int level = image.pixels[static_cast<std::size_t>(i)][0];
      if (level > 20 && level < 60) continue;  // background, whose gradient stays within
      const int x = i % image.width, y = i / image.width;
      box = {std::min(box[0], x), std::max(box[1], x), std::min(box[2], y), std::max(box[3], y)};
    }
    return box;
  }
  void expect_filled(const Image& image) const {
    const auto [left, right, bottom, top] = extent(image);
    EXPECT_GT(left, 0);
    EXPECT_LT(right, image.width - 1);
    EXPECT_GT(bottom, 0);
    EXPECT_LT(top, image.height - 1);
    EXPECT_GT(
        std::max((right - left) / static_cast<double>(image.width), (top - bottom) / static_cast<double>(image.height)),
        0.75);
  }
};

TEST_F(Camera, FrameFillsTheWindowAndHoldsEverythingInAnyShapeAndProjection) {
  ViewOptions options = view->options();
  options.wireframe = true;  // bright from all sides
  view->set_options(options);
  for (const auto& [width, height] : {std::pair{640, 480}, {300, 700}, {900, 250}}) {
    set_size(width, height);
    for (const bool orthographic : {false, true}) {
      camera->set_orthographic(orthographic);
      for (const Axis axis : {Axis::perspective, Axis::front, Axis::top, Axis::left}) {
        camera->look_along(axis);
        frame_all();
        SCOPED_TRACE(testing::Message() << width << " x " << height << (orthographic ? " ortho " : " ")
                                        << static_cast<int>(axis));
        expect_filled(draw());
      }
    }
  }
}

TEST_F(Camera, FrameKeepsTheDirection) {
  camera->tumble(37, 21);
  const Point3 before = forward();
  camera->frame({4, 5, 6, 9, -3, -2});
  EXPECT_NEAR(dot(before, forward()), 1, 1e-12);
  EXPECT_NEAR(length(minus(center(), {4.5, 7.5, -2.5})), 0, 1e-9);
  camera->frame({1, 1, 2, 2, 3, 3});
  EXPECT_NEAR(length(minus(center(), {1, 2, 3})), 0, 1e-9) << "one point is put into the middle";
  EXPECT_TRUE(std::isfinite(length(eye())));
}

TEST_F(Camera, TumbleKeepsTheHorizonLevelTheDistanceAndTheCenter) {
  frame_all();
  const double distance = length(minus(eye(), center()));
  const Point3 middle = center();
  std::mt19937 random(3);
  std::uniform_real_distribution<double> way(-120, 120);
  for (int i = 0; i < 500; ++i) {
    camera->tumble(way(random), way(random));
    ASSERT_NEAR(right()[1], 0, 1e-9) << "no roll";
    ASSERT_NEAR(length(minus(eye(), center())), distance, 1e-6 * distance);
    ASSERT_EQ(center(), middle);
    ASSERT_NEAR(length(up()), 1, 1e-9);
  }
}

TEST_F(Camera, TumbleFollowsTheMouse) {
  camera->look_along(Axis::front);
  frame_all();
  const auto before = view->to_display({0, 0, 1});  // the front face's middle
  camera->tumble(30, 0);
  EXPECT_GT(view->to_display({0, 0, 1})[0], before[0] + 5);
  camera->look_along(Axis::front);
  camera->tumble(0, 30);
  EXPECT_GT(view->to_display({0, 0, 1})[1], before[1] + 5);
  EXPECT_LT(eye()[1], 0);
}

TEST_F(Camera, TumbleFollowsTheMouseUpsideDownToo) {
  camera->look_along(Axis::front);
  frame_all();
  while (up()[1] > -0.95) camera->tumble(0, -5);
  const Point3 nearest = {-forward()[0], -forward()[1], -forward()[2]};
  const auto before = view->to_display(nearest);
  camera->tumble(30, 0);
  EXPECT_GT(view->to_display(nearest)[0], before[0] + 5);
}

TEST_F(Camera, TumblePassesThePolesSmoothly) {
  camera->look_along(Axis::front);
  frame_all();
  Point3 before = eye();
  bool was_upside_down = false;
  for (int i = 0; i < 1200; ++i) {
    camera->tumble(0, -1);
    EXPECT_LT(length(minus(eye(), before)), 0.01 * length(minus(eye(), center()))) << i;
    was_upside_down = was_upside_down || up()[1] < -0.9;
    before = eye();
  }
  EXPECT_TRUE(was_upside_down);
}

TEST_F(Camera, TrackKeepsWhatIsUnderTheMouse) {
  frame_all();
  for (const bool orthographic : {false, true}) {
    camera->set_orthographic(orthographic);
    const Point3 point = center();
    const auto before = view->to_display(point);
    camera->track(57, -31);
    const auto after = view->to_display(point);
    EXPECT_NEAR(after[0] - before[0], 57, 1e-6);
    EXPECT_NEAR(after[1] - before[1], -31, 1e-6);
  }
}

TEST_F(Camera, DollyComesNearerAndNeverArrives) {
  frame_all();
  double distance = length(minus(eye(), center()));
  camera->dolly(50);
  EXPECT_LT(length(minus(eye(), center())), 0.9 * distance);
  camera->dolly(-50);
  EXPECT_NEAR(length(minus(eye(), center())), distance, 1e-9 * distance);
  for (int i = 0; i < 200; ++i) camera->dolly(500);
  EXPECT_GT(length(minus(eye(), center())), 0);
  for (int i = 0; i < 400; ++i) camera->dolly(-500);
  EXPECT_TRUE(std::isfinite(length(eye())));
}

TEST_F(Camera, ZoomKeepsWhatIsUnderTheMouse) {
  frame_all();
  for (const bool orthographic : {false, true}) {
    camera->set_orthographic(orthographic);
    // A point in the plane of the centre.
    Point3 point = center();
    for (std::size_t k = 0; k < 3; ++k) point[k] += 0.4 * right()[k] + 0.2 * up()[k];
    const auto before = view->to_display(point);
    camera->zoom_at(3, before[0], before[1]);
    EXPECT_NEAR(view->to_display(point)[0], before[0], 1e-6);
    EXPECT_NEAR(view->to_display(point)[1], before[1], 1e-6);
  }
}

TEST_F(Camera, BothProjectionsShowTheSameAtTheCenter) {
  camera->tumble(20, 10);
  frame_all();
  Point3 point = center();
  for (std::size_t k = 0; k < 3; ++k) point[k] += 0.5 * right()[k] - 0.3 * up()[k];
  for (int i = 0; i < 3; ++i) {
    camera->set_orthographic(false);
    const auto perspective = view->to_display(point);
    camera->set_orthographic(true);
    EXPECT_TRUE(camera->is_orthographic());
    const auto orthographic = view->to_display(point);
    EXPECT_NEAR(perspective[0], orthographic[0], 1e-6);
    EXPECT_NEAR(perspective[1], orthographic[1], 1e-6);
    camera->dolly(40);
    camera->zoom_at(1, 100, 100);
    for (std::size_t k = 0; k < 3; ++k) point[k] = center()[k] + 0.3 * right()[k];
  }
}

TEST_F(Camera, LooksAlongTheAxesOfAnyUp) {
  const auto expect = [&](Axis axis, const Point3& from, const Point3& screen_up) {
    camera->look_along(axis);
    EXPECT_NEAR(dot(forward(), from), -1, 1e-9) << static_cast<int>(axis);
    EXPECT_NEAR(dot(up(), screen_up), 1, 1e-9) << static_cast<int>(axis);
  };
  frame_all();
  expect(Axis::front, {0, 0, 1}, {0, 1, 0});
  expect(Axis::back, {0, 0, -1}, {0, 1, 0});
  expect(Axis::left, {-1, 0, 0}, {0, 1, 0});
  expect(Axis::right, {1, 0, 0}, {0, 1, 0});
  expect(Axis::top, {0, 1, 0}, {0, 0, -1});
  expect(Axis::bottom, {0, -1, 0}, {0, 0, 1});
  camera->set_up({0, 0, 1});
  expect(Axis::front, {0, -1, 0}, {0, 0, 1});
  expect(Axis::top, {0, 0, 1}, {0, 1, 0});
  camera->tumble(33, 12);
  EXPECT_NEAR(right()[2], 0, 1e-9);
}

TEST_F(Camera, TurnsAboutUpAndCloses) {
  frame_all();
  const Point3 before = eye();
  camera->turn(90);
  EXPECT_NEAR(eye()[1], before[1], 1e-9);
  EXPECT_NEAR(dot(minus(eye(), center()), minus(before, center())), std::pow(before[1] - center()[1], 2), 1e-6);
  for (int i = 0; i < 3; ++i) camera->turn(90);
  EXPECT_NEAR(length(minus(eye(), before)), 0, 1e-9);
}

TEST_F(Camera, CutsNothingOffNearOrFar) {
  ViewOptions options = view->options();
  options.wireframe = options.grid = true;
  view->set_options(options);
  frame_all();
  for (const bool orthographic : {false, true}) {
    camera->set_orthographic(orthographic);
    for (int i = 0; i < 6; ++i) {
      camera->dolly(100);
      double range[2];
      renderer->GetActiveCamera()->GetClippingRange(range);
      for (const double x : {-1, 1}) {
        for (const double z : {-1, 1}) {
          const double depth = dot(minus({x, -1, z}, eye()), forward());
          EXPECT_LT(depth, range[1]);
          EXPECT_TRUE(depth > range[0] || (!orthographic && depth < 0.01)) << depth;
        }
      }
    }
  }
}

}  // namespace
}  // namespace cagewright::host
