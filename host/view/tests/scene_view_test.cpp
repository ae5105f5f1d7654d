// SPDX-License-Identifier: BSD-3-Clause
#include "host/view/window/scene_view.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "host/view/tests/window_fixture.h"

namespace cagewright::host {
namespace {

class SceneLook : public Window {
 protected:
  // The slide `radius` round a sphere, seen from the front and a little above.
  void show_slide(const ShownSlide& slide) {
    view->set_meshes({shown(sphere_mesh(24))});
    view->set_slides({slide});
    frame_all();
  }
  std::array<int, 3> pixel_at(const Image& image, const Point3& point) const {
    const auto [x, y] = view->to_display(point);
    const auto column = static_cast<std::size_t>(std::floor(x)), row = static_cast<std::size_t>(std::floor(y));
    return image.pixels.at(row * static_cast<std::size_t>(image.width) + column);
  }
  // How often colour along the slide's outline changes between `is` and not.
  int changes_along(const Image& image, const ShownSlide& slide, const Image::Colour& is) const {
    int changes = 0;
    bool before = false;
    for (int i = 0; i <= 2000; ++i) {
      const double t = 2 * 3.14159265358979 * i / 2000;
      Point3 point{};
      for (std::size_t k = 0; k < 3; ++k) {
        point[k] = slide.ellipse.center[k] + std::cos(t) * slide.ellipse.u[k] + std::sin(t) * slide.ellipse.v[k];
      }
      const auto [r, g, b] = pixel_at(image, point);
      const bool now = is(r, g, b);
      changes += i > 0 && now != before ? 1 : 0;
      before = now;
    }
    return changes;
  }
};

bool is_reddish(int r, int g, int b) { return r > g + 25 && r > b + 25; }
bool is_text(int r, int g, int b) { return r > 215 && g > 130 && g < 190 && b > 95 && b < 150; }  // of failed slides

double mean_brightness(const Image& image, const Image::Colour& is) {
  double sum = 0;
  long count = 0;
  for (const auto& [r, g, b] : image.pixels) {
    if (is(r, g, b)) sum += r + g + b, ++count;
  }
  return sum / static_cast<double>(count);
}

TEST_F(SceneLook, SlidesAreRedAndGoneWhereTheyAreSwitchedOff) {
  show_slide(level_slide(1, 1.2));
  EXPECT_GT(draw().count(is_red), 500);
  ViewOptions options = view->options();
  options.slides = false;
  show(options);
  const Image without = draw("off");
  EXPECT_EQ(without.count(is_red), 0);
  EXPECT_GT(without.count(is_model_grey), 20000);
}

TEST_F(SceneLook, AMarkedPlaceIsSeenThroughTheModelWhereItIsUntilTheMarkIsTakenAway) {
  view->set_meshes({shown(sphere_mesh(24))});
  frame_all();
  const Image without = draw();
  EXPECT_EQ(without.count(is_orange), 0);
  for (const Point3& place : {Point3{0, 0, -1}, Point3{0.5, 0.3, 0.8}}) {
    view->set_place(place);
    const Image image = draw("marked");
    EXPECT_GT(image.count(is_orange), 100);
    const auto [x, y] = view->to_display(place);
    double column = 0, row = 0;
    int count = 0;
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
      const auto& [r, g, b] = image.pixels[i];
      if (!is_orange(r, g, b)) continue;
      column += static_cast<double>(i % static_cast<std::size_t>(image.width));
      row += static_cast<double>(i / static_cast<std::size_t>(image.width));
      ++count;
    }
    EXPECT_NEAR(column / count, x, 1.5);
    EXPECT_NEAR(row / count, y, 1.5);
  }
  view->set_place(Point3{0, 0, 40});  // behind the viewer
  EXPECT_EQ(draw().count(is_orange), 0);
  view->set_place({});
  EXPECT_EQ(draw().pixels, without.pixels);
}

TEST_F(SceneLook, SelectedSlidesAreYellowAndPreviewsPalerThanOthers) {
  ShownSlide slide = level_slide(1, 1.2);
  slide.is_selected = true;
  show_slide(slide);
  const Image selected = draw("selected");
  EXPECT_GT(selected.count(is_yellow), 500);
  EXPECT_EQ(selected.count(is_red), 0);
  slide.is_selected = false;
  slide.is_preview = true;
  view->set_slides({slide});
  const Image preview = draw("preview");
  EXPECT_EQ(preview.count(is_red) + preview.count(is_yellow), 0);
  EXPECT_GT(preview.count([](int r, int g, int b) { return r > 200 && g > 90 && g < 170 && std::abs(g - b) < 30; }),
            500);
}

TEST_F(SceneLook, SlidesBehindTheModelShowThroughFaintly) {
  const ShownSlide slide = level_slide(1, 0.5);  // inside the sphere
  show_slide(slide);
  const Image image = draw();
  EXPECT_EQ(image.count(is_red), 0);
  EXPECT_GT(image.count([](int r, int g, int b) { return r > g + 30 && r > b + 30; }), 300);
}

// Where the eye is within it, clipping planes are far apart, and most of the depths between them are near the eye.
TEST_F(SceneLook, LinesBehindAModelAreHiddenAndThoseBeforeItAreNotAlsoInAMuchLargerScene) {
  for (const double size : {1.0, 60.0}) {
    SCOPED_TRACE(size);
    show_slide(level_slide(1, 0.97));  // just inside the sphere
    view->set_meshes({shown(sphere_mesh(96)), shown(box_mesh(size), 1, false)});
    ViewOptions options = view->options();
    options.other_meshes = size > 1;
    show(options);
    EXPECT_LT(draw("inside").count(is_red), 10);
    view->set_slides({level_slide(1, 1.0)});  // on it
    EXPECT_GT(draw("on").count(is_red), 200);
  }
}

TEST_F(SceneLook, FailedSlidesAreDashedWithTheirSentenceBeside) {
  ShownSlide slide = level_slide(1, 1.3, 0);
  show_slide(slide);
  EXPECT_LT(changes_along(draw("whole"), slide, is_reddish), 6);
  slide.failed = true;
  view->set_slides({slide});
  const Image dashed = draw("dashed");
  EXPECT_GT(changes_along(dashed, slide, is_orange), 14);
  EXPECT_GT(dashed.count(is_orange), 200);
  EXPECT_EQ(dashed.count(is_text), 0);
  slide.label = "slide 1: no loop of the model encloses its centre; move it onto a limb, or draw the stroke again";
  view->set_slides({slide});
  const Image labelled = draw("labelled");
  EXPECT_GT(labelled.count(is_text), 200);
  ViewOptions options = view->options();
  options.slides = false;
  show(options);
  EXPECT_EQ(draw("off").count(is_text), 0);
}

TEST_F(SceneLook, LabelsStayInTheWindowAndOffOneAnother) {
  std::vector<ShownSlide> slides;
  for (int i = 0; i < 4; ++i) {
    slides.push_back(level_slide(i, 1, 0.01 * i));
    slides.back().failed = true;
    slides.back().label = "this slide does not cut the model anywhere at all, look";
  }
  view->set_meshes({shown(sphere_mesh(12))});
  view->set_slides(slides);
  frame_all();
  // Text of four labels: four times that of one, if none hides another or is cut off.
  const auto four = static_cast<double>(draw().count(is_text));
  slides.resize(1);
  view->set_slides(slides);
  const auto one = static_cast<double>(draw().count(is_text));
  EXPECT_GT(one, 200);
  EXPECT_NEAR(four / one, 4, 0.1);
}

TEST_F(SceneLook, OfManySentencesAFewAreShownThoseOfSelectedSlidesFirstAndHowManyMoreThereAre) {
  std::vector<ShownSlide> slides;
  for (int i = 0; i < 29; ++i) {
    slides.push_back(level_slide(i, 1, 0.01 * i));
    slides.back().failed = true;
    slides.back().label = "this slide does not cut the model anywhere at all, look";
  }
  view->set_meshes({shown(sphere_mesh(12))});
  view->set_slides({slides.front()});
  frame_all();
  const auto one = static_cast<double>(draw().count(is_text));
  view->set_slides({slides.begin(), slides.begin() + 5});
  const auto five = static_cast<double>(draw().count(is_text));
  view->set_slides(slides);
  const auto many = static_cast<double>(draw("many").count(is_text));
  EXPECT_NEAR(five / one, 5, 0.1);
  EXPECT_GT(many, five + 0.2 * one) << "how many more there are is said";
  EXPECT_LT(many, five + 0.8 * one);
  slides.back().label = "|";  // hardly any text
  slides.back().is_selected = true;
  view->set_slides(slides);
  EXPECT_LT(static_cast<double>(draw("selected").count(is_text)), many - 0.7 * one);
}

TEST_F(SceneLook, LabelsAreOfSlidesThatAreInTheWindowAlone) {
  ShownSlide far = level_slide(1, 0.3), near = level_slide(2, 1);
  far.failed = true;
  far.label = "this slide does not cut the model anywhere at all, look";
  view->set_meshes({shown(sphere_mesh(12))});
  view->set_slides({near});
  frame_all();
  for (const Point3& off : {Point3{4, 0, 0}, Point3{-4, 0, 0}, Point3{0, 4, 0}, Point3{0, -4, 0}}) {
    far.ellipse.center = off;
    view->set_slides({far, near});
    EXPECT_EQ(draw("off the window").count(is_text), 0);
  }
  far.ellipse.center = {0, 0.5, 0};
  view->set_slides({far, near});
  EXPECT_GT(draw("in the window").count(is_text), 200);
  // So near that only a piece of it is in the window.
  far.ellipse.center = {-30, 0.5, 0};
  far.ellipse.u = {30, 0, 0};
  far.ellipse.v = {0, 0, 30};
  view->set_slides({far, near});
  EXPECT_GT(draw("a piece of it").count(is_text), 200);
}

TEST_F(SceneLook, CageHasTranslucentFacesAndEdgesAndSectionsAreGreen) {
  view->set_meshes({shown(sphere_mesh(24))});
  const ShownCage cage = box_cage(1.3);
  view->set_cage(&cage);
  frame_all();
  const Image all = draw("all");
  EXPECT_GT(all.count(is_blue), 1500);
  EXPECT_GT(all.count(is_green), 500);
  EXPECT_GT(all.count([](int r, int, int b) { return b > r + 10 && b > 90 && r > 60; }), 5000) << "model through faces";
  ViewOptions options = view->options();
  options.sections = false;
  show(options);
  EXPECT_EQ(draw("no sections").count(is_green), 0);
  options.cage_faces = false;
  show(options);
  const Image edges = draw("edges");
  EXPECT_GT(edges.count(is_blue), 1500);
  EXPECT_GT(edges.count(is_model_grey), 10000) << "no blue over the model";
  options.cage = false;
  show(options);
  EXPECT_EQ(draw("none").count(is_blue), 0);
  options.cage = options.sections = true;
  show(options);
  view->set_cage(nullptr);
  const Image none = draw("null");
  EXPECT_EQ(none.count(is_blue) + none.count(is_green), 0);
}

TEST_F(SceneLook, StaleCagesArePaler) {
  view->set_meshes({shown(sphere_mesh(24))});
  ShownCage cage = box_cage(1.3);
  view->set_cage(&cage);
  frame_all();
  EXPECT_GT(draw().count(is_blue), 1000);
  cage.is_stale = true;
  view->set_cage(&cage);
  const Image stale = draw("stale");
  EXPECT_EQ(stale.count(is_blue), 0);
  EXPECT_EQ(stale.count(is_green), 0);
  EXPECT_GT(stale.count([](int r, int, int b) { return b > 90 && b > r + 8; }), 500);
}

TEST_F(SceneLook, PartsHaveColoursOfTheirOwn) {
  const auto mesh = sphere_mesh(24);
  view->set_meshes({shown(mesh)});
  frame_all();
  std::vector<int> parts;
  for (std::size_t i = 0; i < mesh->triangles.size(); i += 3) {
    parts.push_back(static_cast<int>(3 * (mesh->points[3 * mesh->triangles[i] + 1] + 1)));
  }
  view->set_parts(*mesh, parts);
  EXPECT_GT(draw("plain").count(is_model_grey), 20000) << "only where colours are asked for";
  ViewOptions options = view->options();
  options.colours = ViewOptions::Colours::parts;
  show(options);
  const Image image = draw("parts");
  std::set<int> hues;
  for (const auto& [r, g, b] : image.pixels) {
    const int most = std::max({r, g, b}), least = std::min({r, g, b});
    if (most < 100 || most - least < most / 3) continue;
    hues.insert(static_cast<int>(std::lround(std::atan2(std::sqrt(3) * (g - b), 2 * r - g - b) / 0.35)));
  }
  EXPECT_GE(hues.size(), 5u);
  EXPECT_LT(image.count(is_model_grey), 200);
  // Two halves: each triangle has its own part's colour.
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const auto height = [&](std::size_t k) { return mesh->points[3 * std::size_t{mesh->triangles[3 * i + k]} + 1]; };
    parts[i] = height(0) + height(1) + height(2) > 0 ? 1 : 0;
  }
  view->set_parts(*mesh, parts);
  const Image halves = draw("halves");
  const auto share = [&](double y, double x) {  // of red in the colour, at a point of the front
    const auto [r, g, b] = pixel_at(halves, {x, y, std::sqrt(1 - x * x - y * y)});
    return r / static_cast<double>(r + g + b);
  };
  for (const double y : {0.3, 0.6}) {
    for (const double x : {-0.5, 0.0, 0.5}) {
      EXPECT_NEAR(share(y, x), share(0.4, 0.1), 0.02);
      EXPECT_NEAR(share(-y, x), share(-0.4, 0.1), 0.02);
    }
  }
  EXPECT_GT(std::abs(share(0.4, 0.1) - share(-0.4, 0.1)), 0.1);
  view->set_meshes({shown(box_mesh(1))});
  EXPECT_GT(draw("other model").count(is_model_grey), 20000) << "another model has no parts yet";
}

TEST_F(SceneLook, WhatPokesOutIsRedWhereCoverageIsShown) {
  const auto mesh = sphere_mesh(24);
  view->set_meshes({shown(mesh)});
  frame_all();
  const Image plain = draw("plain");
  ViewOptions options = view->options();
  options.colours = ViewOptions::Colours::coverage;
  show(options);
  const Image covered = draw("covered");
  EXPECT_EQ(covered.count(is_red), 0);
  EXPECT_NEAR(mean_brightness(covered, is_model_grey), mean_brightness(plain, is_model_grey), 6);
  std::vector<std::uint32_t> outside;
  for (std::uint32_t i = 0; i < mesh->vertex_count(); ++i) {
    if (mesh->points[3 * std::size_t{i} + 1] > 0.6) outside.push_back(i);
  }
  view->set_outside(outside);
  const Image poking = draw("outside");
  EXPECT_GT(poking.count(is_red), 2000);
  EXPECT_GT(poking.mean_height(is_red), 0.65);
  view->set_outside({mesh->vertex_count() > 300 ? 300u : 0u, 1'000'000u});
  EXPECT_GT(draw("one vertex").count(is_red), 9) << "a single vertex can be seen; one that is none does no harm";
  view->set_outside({});
  EXPECT_EQ(draw("none").count(is_red), 0);
}

TEST_F(SceneLook, OtherMeshesAreDim) {
  ShownMesh other = shown(sphere_mesh(24), 1, false);
  other.to_scene = translation(2.5, 0, 0);
  view->set_meshes({shown(sphere_mesh(24)), other});
  frame_all();
  camera->look_along(CameraControl::Axis::front);
  const Image image = draw();
  const auto sphere = [](int r, int g, int b) { return is_model_grey(r, g, b); };
  EXPECT_GT(image.count(sphere, 0, 0.5), 3 * image.count(sphere, 0.5, 1));
}

TEST_F(SceneLook, OtherMeshesThatAreSwitchedOffHideNothingAndAreNotFoundUnderTheMouse) {
  ShownMesh other = shown(sphere_mesh(24), 1, false);
  other.to_scene = translation(0, 0, 3);
  view->set_meshes({shown(sphere_mesh(24)), other});
  camera->look_along(CameraControl::Axis::front);
  frame_all();
  EXPECT_EQ(view->pick(320, 240, false).node, 1);
  const auto behind = draw("behind").count(is_model_grey);
  ViewOptions options = view->options();
  options.other_meshes = false;
  show(options);
  EXPECT_GT(draw("alone").count(is_model_grey), behind + 5000);
  EXPECT_EQ(view->pick(320, 240, false).node, 0);
}

TEST_F(SceneLook, MirroredAndClosedMeshesShowTheirOutside) {
  ShownMesh mirrored = shown(sphere_mesh(24));
  mirrored.to_scene = scaling(-1, 1, 1);
  view->set_meshes({shown(sphere_mesh(24))});
  frame_all();
  camera->look_along(CameraControl::Axis::front);
  const Image plain = draw("plain");
  view->set_meshes({mirrored});
  const Image other = draw("mirrored");
  EXPECT_NEAR(mean_brightness(other, is_model_grey), mean_brightness(plain, is_model_grey), 3);
}

TEST_F(SceneLook, OpenMeshesShowTheirInside) {
  auto open = std::make_shared<TriangleMesh>(*box_mesh(1));
  open->triangles.erase(open->triangles.begin() + 6, open->triangles.begin() + 12);  // the front, z > 0
  view->set_meshes({shown(open)});
  frame_all();
  camera->look_along(CameraControl::Axis::front);
  const Image image = draw();
  const auto [r, g, b] =
      image.pixels[static_cast<std::size_t>(image.height / 2) * static_cast<std::size_t>(image.width) + 320];
  EXPECT_TRUE(is_model_grey(r, g, b)) << r << ' ' << g << ' ' << b;
}

TEST_F(SceneLook, WireframeShowsWhatIsBehindTheModel) {
  view->set_meshes({shown(box_mesh(1))});
  frame_all();
  const long shaded = draw("shaded").count(is_model_grey);
  ViewOptions options = view->options();
  options.wireframe = true;
  show(options);
  const long wires = draw("wires").count(is_model_grey);
  EXPECT_GT(wires, 300);
  EXPECT_LT(wires, shaded / 5);
}

TEST_F(SceneLook, ModelAndGridCanBeSwitchedOffAndTheBackgroundLight) {
  view->set_meshes({shown(box_mesh(1))});
  frame_all();
  ViewOptions options = view->options();
  options.model = false;
  show(options);
  const Image empty = draw("empty");
  EXPECT_EQ(empty.count([](int r, int, int) { return r > 60; }), 0);
  EXPECT_GT(empty.pixels.back()[0], empty.pixels.front()[0]) << "a gradient, lighter above";
  options.grid = true;
  show(options);
  EXPECT_GT(draw("grid").count([](int r, int, int) { return r > 60; }), 1000);
  options.dark = false;
  show(options);
  EXPECT_GT(draw("light").count([](int r, int g, int b) { return r > 190 && g > 190 && b > 190; }), 200000);
}

TEST_F(SceneLook, StrokesAreDrawnOnTheModel) {
  view->set_meshes({shown(sphere_mesh(24))});
  frame_all();
  view->set_stroke({{0, 0, 1}, {0.3, 0.3, 0.9}, {0.6, 0.3, 0.74}});
  EXPECT_GT(draw("stroke").count(is_yellow), 100);
  view->set_stroke({});
  EXPECT_EQ(draw("none").count(is_yellow), 0);
}

TEST_F(SceneLook, SlidesThatAreNotFiniteAreLeftOut) {
  ShownSlide broken = level_slide(2, 1.2);
  broken.ellipse.u[1] = std::numeric_limits<double>::quiet_NaN();
  show_slide(level_slide(1, 1.2));
  const auto bounds = view->bounds();
  const long before = draw("one").count(is_red);
  view->set_slides({broken, level_slide(1, 1.2)});
  EXPECT_EQ(view->bounds(), bounds);
  EXPECT_EQ(draw("both").count(is_red), before);
}

TEST_F(SceneLook, LinesAndLabelsGrowWithTheWindowsDpi) {
  ShownSlide slide = level_slide(1, 1.2);
  slide.is_selected = true;
  show_slide(slide);
  const auto narrow = static_cast<double>(draw("72").count(is_yellow));
  window->SetDPI(144);
  EXPECT_GT(static_cast<double>(draw("144").count(is_yellow)), 1.7 * narrow);
}

TEST_F(SceneLook, BoundsAreOfTheSceneWithoutItsCageAndOfSlidesAsked) {
  EXPECT_FALSE(view->bounds().has_value());
  EXPECT_FALSE(view->bounds_of_place({0, 0, 0}).has_value());
  ShownMesh mesh = shown(box_mesh(1));
  mesh.to_scene = product(translation(10, 0, 0), scaling(1, 2, -3));
  view->set_meshes({mesh});
  EXPECT_EQ(*view->bounds(), (std::array<double, 6>{9, 11, -2, 2, -3, 3}));
  const ShownCage cage = box_cage(9);
  view->set_cage(&cage);
  EXPECT_EQ(*view->bounds(), (std::array<double, 6>{9, 11, -2, 2, -3, 3})) << "of meshes and slides alone";
  view->set_slides({level_slide(7, 0.5, 1), level_slide(8, 0.25, -1)});
  const auto slide = *view->bounds_of_slides({7});
  const std::array<double, 6> expected{9.5, 10.5, 2, 2, -1.5, 1.5};
  for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(slide[i], expected[i], 1e-9) << i;
  EXPECT_FALSE(view->bounds_of_slides({9}).has_value());
  const auto place = *view->bounds_of_place({0, 0.5, 0});
  EXPECT_NEAR((place[0] + place[1]) / 2, 10, 1e-9);
  EXPECT_NEAR((place[2] + place[3]) / 2, 1, 1e-9);
  EXPECT_LT(place[1] - place[0], 2);
  EXPECT_GT(place[1] - place[0], 0.1);
}

}  // namespace
}  // namespace cagewright::host
