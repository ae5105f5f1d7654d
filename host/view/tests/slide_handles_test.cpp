// SPDX-License-Identifier: BSD-3-Clause
#include "host/view/window/slide_handles.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "host/view/tests/window_fixture.h"

namespace cagewright::host {
namespace {

using Mode = SlideHandles::Mode;
using Ellipses = std::vector<std::pair<std::int64_t, Slide::Ellipse>>;

double length(const Point3& a) { return std::hypot(a[0], a[1], a[2]); }
Point3 minus(const Point3& a, const Point3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Point3 plus(const Point3& a, const Point3& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }

class Handles : public Window {
 protected:
  Handles() { show_model(translation(0, 0, 0)); }

  void show_model(const Matrix4& to_scene) {
    ShownMesh mesh = shown(sphere_mesh(24));
    mesh.to_scene = to_scene;
    view->set_meshes({mesh});
    frame_all();
    handles = std::make_unique<SlideHandles>(*renderer, *view);
    handles->set_slides({{5, slide}});
  }
  // Presses handle `index` and moves by that many pixels.
  Ellipses drag(std::size_t index, double dx, double dy, bool snap = false, int steps = 7) {
    const auto [x, y] = view->to_display(handles->places().at(index));
    EXPECT_TRUE(handles->begin(x, y));
    Ellipses moved;
    for (int i = 1; i <= steps; ++i) moved = handles->drag(x + dx * i / steps, y + dy * i / steps, snap);
    handles->end();
    return moved;
  }
  // From here on the screen to there, in pixels.
  std::array<double, 2> way(const Point3& from, const Point3& to) const {
    const auto a = view->to_display(from), b = view->to_display(to);
    return {b[0] - a[0], b[1] - a[1]};
  }
  static void expect_sound(const Ellipses& slides) {
    for (const auto& [id, ellipse] : slides) {
      for (const Point3& part : {ellipse.center, ellipse.u, ellipse.v}) {
        EXPECT_TRUE(std::isfinite(length(part)));
        EXPECT_LT(length(part), 1e3);
      }
      EXPECT_GT(length(ellipse.u), 1e-4);
      EXPECT_GT(length(ellipse.v), 1e-4);
    }
  }

  Slide::Ellipse slide{{0.1, 0.2, 0}, {0.8, 0, 0.1}, {0.05, 0, -0.4}};
  std::unique_ptr<SlideHandles> handles;
};

TEST_F(Handles, StandThereOnlyWithAModeAndASlide) {
  EXPECT_TRUE(handles->places().empty());
  EXPECT_FALSE(handles->begin(320, 240));
  handles->set_mode(Mode::move);
  EXPECT_EQ(handles->places().size(), 5u);
  EXPECT_EQ(handles->label(), "move slide");
  handles->set_mode(Mode::turn);
  EXPECT_EQ(handles->places().size(), 3u);
  EXPECT_EQ(handles->label(), "turn slide");
  handles->set_mode(Mode::scale);
  EXPECT_EQ(handles->places().size(), 3u);
  EXPECT_EQ(handles->label(), "scale slide");
  EXPECT_EQ(handles->mode(), Mode::scale);
  handles->set_slides({});
  EXPECT_TRUE(handles->places().empty());
  handles->set_slides({{1, {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}}});
  EXPECT_TRUE(handles->places().empty()) << "an ellipse without a plane";
  draw();
}

TEST_F(Handles, AreDrawnOverTheModelInTheirColoursAndBrighterUnderTheMouse) {
  const Image without = draw("none");
  EXPECT_EQ(without.count(is_blue), 0);
  handles->set_mode(Mode::move);  // their centre is inside the sphere
  const Image image = draw("move");
  EXPECT_GT(image.count(is_blue), 100);
  EXPECT_GT(image.count(is_green), 100);
  EXPECT_GT(image.count([](int r, int g, int b) { return r > 220 && g < 90 && b < 90; }), 100);
  const auto is_bright = [](int r, int g, int b) { return r > 240 && g > 240 && b > 110 && b < 180; };
  EXPECT_EQ(image.count(is_bright), 0);
  const auto [x, y] = view->to_display(handles->places()[2]);
  EXPECT_TRUE(handles->hover(x, y));
  EXPECT_GT(draw("hover").count(is_bright), 100);
  EXPECT_FALSE(handles->hover(2, 2));
  EXPECT_EQ(draw("left").count(is_bright), 0);
  for (const Mode mode : {Mode::turn, Mode::scale}) {
    handles->set_mode(mode);
    EXPECT_GT(draw(mode == Mode::turn ? "turn" : "scale").count(is_green), 100);
  }
}

TEST_F(Handles, KeepTheirSizeOnTheScreen) {
  handles->set_mode(Mode::move);
  for (const double pixels : {0, 120, -300}) {
    camera->dolly(pixels);
    handles->update();
    const auto [x, y] = way(slide.center, handles->places()[0]);
    EXPECT_NEAR(std::hypot(x, y), 75, 20) << pixels;
  }
}

TEST_F(Handles, EveryPlaceCanBePressedFromManySidesAndInOddSpaces) {
  for (const Matrix4& to_scene : {translation(0, 0, 0), product(translation(2, 1, 0), scaling(-2, 0.6, 1))}) {
    show_model(to_scene);
    for (const Mode mode : {Mode::move, Mode::turn, Mode::scale}) {
      handles->set_mode(mode);
      for (int i = 0; i < 8; ++i) {
        camera->turn(17);
        for (const Point3& place : handles->places()) {
          const auto [x, y] = view->to_display(place);
          EXPECT_TRUE(handles->begin(x, y)) << static_cast<int>(mode) << ' ' << i;
          EXPECT_TRUE(handles->is_dragging());
          handles->end();
          EXPECT_FALSE(handles->is_dragging());
        }
      }
    }
  }
}

TEST_F(Handles, MovingFollowsTheMouseAlongItsAxis) {
  for (const Matrix4& to_scene : {translation(0, 0, 0), product(translation(2, 1, 0), scaling(-2, 0.6, 1))}) {
    show_model(to_scene);
    handles->set_mode(Mode::move);
    const Point3 axes[] = {slide.u, slide.v, {0, 1, 0}};
    for (std::size_t k = 0; k < 3; ++k) {
      handles->set_slides({{5, slide}});
      Point3 goal = handles->places()[k];
      for (std::size_t i = 0; i < 3; ++i) goal[i] += 0.3 * axes[k][i] / length(axes[k]);
      const auto [dx, dy] = way(handles->places()[k], goal);
      const auto moved = drag(k, dx, dy);
      ASSERT_EQ(moved.size(), 1u);
      EXPECT_EQ(moved[0].first, 5);
      const Point3 by = minus(moved[0].second.center, slide.center);
      EXPECT_NEAR(length(by), 0.3, 1e-3) << k;
      EXPECT_NEAR((by[0] * axes[k][0] + by[1] * axes[k][1] + by[2] * axes[k][2]) / length(axes[k]), 0.3, 2e-2) << k;
      EXPECT_EQ(moved[0].second.u, slide.u);
      EXPECT_EQ(moved[0].second.v, slide.v);
    }
  }
}

TEST_F(Handles, ThePlaneHandleStaysInThePlaneAndTheBallInTheScreens) {
  handles->set_mode(Mode::move);
  const Point3 goal = plus(handles->places()[3], {0.2, 0, -0.1});
  const auto [dx, dy] = way(handles->places()[3], goal);
  Point3 by = minus(drag(3, dx, dy)[0].second.center, slide.center);
  EXPECT_NEAR(by[0], 0.2, 1e-6);
  EXPECT_NEAR(by[1], 0, 1e-9);
  EXPECT_NEAR(by[2], -0.1, 1e-6);
  handles->set_slides({{5, slide}});
  const auto before = view->to_display(slide.center);
  const auto after = view->to_display(drag(4, 40, -25)[0].second.center);
  EXPECT_NEAR(after[0] - before[0], 40, 1e-6);
  EXPECT_NEAR(after[1] - before[1], -25, 1e-6);
}

TEST_F(Handles, SeveralSlidesMoveAlikeAndTurnAndScaleAboutTheirOwnCenters) {
  Slide::Ellipse other = slide;
  other.center = {0, -0.5, 0.3};
  const Ellipses both{{1, other}, {2, slide}};
  handles->set_mode(Mode::move);
  handles->set_slides(both);
  auto moved = drag(4, 30, 20);
  EXPECT_NEAR(length(minus(minus(moved[0].second.center, other.center), minus(moved[1].second.center, slide.center))),
              0, 1e-9);
  for (const Mode mode : {Mode::turn, Mode::scale}) {
    handles->set_mode(mode);
    handles->set_slides(both);
    moved = drag(0, 20, 25);
    EXPECT_NEAR(length(minus(moved[0].second.center, other.center)), 0, 1e-12);
    EXPECT_NEAR(length(minus(moved[1].second.center, slide.center)), 0, 1e-12);
    EXPECT_NEAR(length(minus(moved[0].second.v, moved[1].second.v)), 0, 1e-9);
    EXPECT_GT(length(minus(moved[0].second.v, slide.v)) + length(minus(moved[0].second.u, slide.u)), 0.01);
  }
}

TEST_F(Handles, TurningKeepsRadiiAndFollowsTheRing) {
  handles->set_mode(Mode::turn);
  const Point3 place = handles->places()[2];  // about the normal, +y
  const Point3 arm = minus(place, slide.center);
  const double angle = 0.5, c = std::cos(angle), s = std::sin(angle);
  const Point3 goal = plus(slide.center, {c * arm[0] + s * arm[2], arm[1], -s * arm[0] + c * arm[2]});
  const auto [dx, dy] = way(place, goal);
  const auto turned = drag(2, dx, dy)[0].second;
  EXPECT_NEAR(turned.u[0], c * slide.u[0] + s * slide.u[2], 1e-6);
  EXPECT_NEAR(turned.u[2], -s * slide.u[0] + c * slide.u[2], 1e-6);
  EXPECT_NEAR(length(turned.u), length(slide.u), 1e-9);
  EXPECT_NEAR(length(turned.v), length(slide.v), 1e-9);
  handles->set_slides({{5, slide}});
  const auto snapped = drag(2, dx, dy, true)[0].second;  // 0.5 is nearest to 30 degrees
  EXPECT_NEAR(std::atan2(-snapped.u[2], snapped.u[0]) - std::atan2(-slide.u[2], slide.u[0]), std::numbers::pi / 6,
              1e-9);
}

TEST_F(Handles, ARingTurnsWithTheMouseRoundAndRound) {
  handles->set_mode(Mode::turn);
  camera->look_along(CameraControl::Axis::top);
  const Point3 place = handles->places()[2];
  const auto [x, y] = view->to_display(place);
  ASSERT_TRUE(handles->begin(x, y));
  const auto [cx, cy] = view->to_display(slide.center);
  Ellipses turned;
  for (int i = 1; i <= 40; ++i) {
    const double t = 2 * std::numbers::pi * i / 40;
    turned = handles->drag(cx + std::cos(t) * (x - cx) - std::sin(t) * (y - cy),
                           cy + std::sin(t) * (x - cx) + std::cos(t) * (y - cy), false);
    expect_sound(turned);
  }
  EXPECT_NEAR(length(minus(turned[0].second.u, slide.u)), 0, 1e-6);
}

TEST_F(Handles, ScalingGrowsWhatIsPulledAndNeverReachesZero) {
  handles->set_mode(Mode::scale);
  const Point3 place = handles->places()[0];
  const auto [dx, dy] = way(place, plus(place, minus(place, slide.center)));
  const auto doubled = drag(0, dx, dy)[0].second;
  EXPECT_NEAR(length(doubled.u) / length(slide.u), 2, 0.02);
  EXPECT_EQ(doubled.v, slide.v);
  handles->set_slides({{5, slide}});
  const auto snapped = drag(0, dx, dy, true)[0].second;
  const double factor = length(snapped.u) / length(slide.u);
  EXPECT_NEAR(factor * 10, std::round(factor * 10), 1e-9);
  for (std::size_t k = 0; k < 3; ++k) {
    for (const bool snap : {false, true}) {
      handles->set_slides({{5, slide}});
      const auto at = view->to_display(handles->places()[k]);
      const auto center = view->to_display(slide.center);
      const double px = k == 2 ? -600 : 6 * (center[0] - at[0]), py = k == 2 ? -600 : 6 * (center[1] - at[1]);
      const auto small = drag(k, px, py, snap)[0].second;
      EXPECT_GE(length(small.u) / length(slide.u), 1e-3 * (1 - 1e-9));
      EXPECT_GE(length(small.v) / length(slide.v), 1e-3 * (1 - 1e-9));
      EXPECT_LT(std::min(length(small.u), length(small.v)), 0.2);
    }
  }
  handles->set_slides({{5, slide}});
  const auto both = drag(2, 45, 0)[0].second;
  EXPECT_NEAR(length(both.u) / length(slide.u), length(both.v) / length(slide.v), 1e-9);
  EXPECT_GT(length(both.u), 1.2 * length(slide.u));
}

TEST_F(Handles, NothingExplodesWhereAxesPointAtTheViewerAndPlanesAreEdgeOn) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> x(-50, 690), y(-50, 530);
  for (const auto axis : {CameraControl::Axis::front, CameraControl::Axis::top, CameraControl::Axis::right}) {
    for (const bool orthographic : {false, true}) {
      camera->set_orthographic(orthographic);
      camera->look_along(axis);
      camera->tumble(6, 4);  // two degrees beside it: where a pixel is worth most
      for (const Mode mode : {Mode::move, Mode::turn, Mode::scale}) {
        handles->set_mode(mode);
        handles->set_slides({{5, {{0, 0, 0}, {1, 0, 0}, {0, 0, -1}}}});
        const auto places = handles->places();
        const bool is_from_right = axis == CameraControl::Axis::right;
        const auto [px, py] = way({0, 0, 0}, is_from_right ? Point3{0, 0, 0.1} : Point3{0.1, 0, 0});
        const double pixel = 0.1 / std::hypot(px, py);
        for (const Point3& place : places) {
          handles->set_slides({{5, {{0, 0, 0}, {1, 0, 0}, {0, 0, -1}}}});
          const auto at = view->to_display(place);
          if (!handles->begin(at[0], at[1])) continue;  // an arrow straight at the viewer is under the ball
          for (int i = 0; i < 40; ++i) {
            const double to_x = x(random), to_y = y(random);
            const auto dragged = handles->drag(to_x, to_y, false);
            expect_sound(dragged);
            // No pixel is worth more than ten of them are on the screen.
            EXPECT_LE(length(dragged[0].second.center), 10.2 * pixel * std::hypot(to_x - at[0], to_y - at[1]));
          }
          const auto here = handles->drag(at[0], at[1], false)[0].second;
          EXPECT_NEAR(length(here.center), 0, 1e-6);
          handles->end();
        }
      }
    }
  }
}

TEST_F(Handles, ARingSeenFromItsSideFollowsTheMouseToo) {
  camera->look_along(CameraControl::Axis::front);
  camera->set_orthographic(true);
  const Slide::Ellipse level{{0, 0, 0}, {1, 0, 0}, {0, 0, -1}};
  handles->set_mode(Mode::turn);
  handles->set_slides({{5, level}});
  // About the normal, +y, seen as a line: the near side goes to the right with the mouse, so front (+z) turns to +x.
  const auto [x, y] = view->to_display({0.02, 0, 0});
  ASSERT_TRUE(handles->begin(x, y));
  const auto turned = handles->drag(x + 45, y, false)[0].second;
  EXPECT_NEAR(turned.u[0], std::cos(0.5), 1e-9);
  EXPECT_NEAR(turned.u[2], -std::sin(0.5), 1e-9);
}

TEST_F(Handles, StayWhereTheyAreWhileNothingIsDragged) {
  handles->set_mode(Mode::move);
  const auto same = handles->drag(100, 100, false);
  ASSERT_EQ(same.size(), 1u);
  EXPECT_EQ(same[0].second.center, slide.center);
  handles->end();
}

}  // namespace
}  // namespace cagewright::host
