// SPDX-License-Identifier: BSD-3-Clause
// Places that the model hides, and where it is open.
#include <gtest/gtest.h>

#include <algorithm>

#include "host/view/tests/window_fixture.h"
#include "host/view/window/open_edges.h"

namespace cagewright::host {
namespace {

double dot(const Point3& a, const Point3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

// A sphere without the triangle fan at its pole (0, 1, 0).
std::shared_ptr<const TriangleMesh> open_sphere(int rows) {
  auto mesh = std::make_shared<TriangleMesh>(*sphere_mesh(rows));
  std::vector<std::uint32_t> kept;
  for (std::size_t i = 0; i < mesh->triangles.size(); i += 3) {
    const auto corner = mesh->triangles.begin() + static_cast<std::ptrdiff_t>(i);
    if (std::find(corner, corner + 3, 0U) == corner + 3) kept.insert(kept.end(), corner, corner + 3);
  }
  mesh->triangles = kept;
  return mesh;
}

class SceneSight : public Window {};

TEST_F(SceneSight, WhatIsSeenNeedsNoTurnAndWhatIsBehindTheModelIsSeenFromItsOwnSide) {
  view->set_meshes({shown(sphere_mesh(24))});
  camera->look_along(CameraControl::Axis::front);
  frame_all();
  EXPECT_FALSE(view->direction_to_see({0, 0, 1}).has_value());
  for (const Point3& place : {Point3{0, 0, -1}, Point3{0.6, 0, -0.8}, Point3{0, -0.6, -0.8}}) {
    const auto toward_viewer = view->direction_to_see(place);
    ASSERT_TRUE(toward_viewer.has_value());
    EXPECT_GT(dot(*toward_viewer, place), 0.95);
    camera->look_from(*toward_viewer);
    frame_all();
    EXPECT_FALSE(view->direction_to_see(place).has_value()) << "it is seen now";
    camera->look_along(CameraControl::Axis::front);
  }
}

TEST_F(SceneSight, WhatIsSeenFromTheSideAloneIsLookedAtStraight) {
  view->set_meshes({shown(sphere_mesh(24))});
  camera->set_orthographic(true);
  camera->look_along(CameraControl::Axis::front);
  frame_all();
  EXPECT_TRUE(view->direction_to_see({0.997, 0, 0.077}).has_value());
  EXPECT_FALSE(view->direction_to_see({0.9, 0, 0.43}).has_value());
}

TEST_F(SceneSight, APlaceWithinTheModelIsSeenFromNowhereAndNothingIsTurned) {
  view->set_meshes({shown(sphere_mesh(24))});
  frame_all();
  EXPECT_FALSE(view->direction_to_see({0.01, 0.02, 0.03}).has_value());
}

TEST_F(SceneSight, AMirroredMeshIsLookedAtFromOutside) {
  ShownMesh mesh = shown(sphere_mesh(24));
  mesh.to_scene = product(translation(3, 0, 0), scaling(-2, 2, 2));
  view->set_meshes({mesh});
  camera->look_along(CameraControl::Axis::front);
  frame_all();
  const auto toward_viewer = view->direction_to_see({0.6, 0, -0.8});
  ASSERT_TRUE(toward_viewer.has_value());
  EXPECT_GT(dot(*toward_viewer, {-0.6, 0, -0.8}), 0.95);
}

TEST_F(SceneSight, TheEdgesWhereTheModelIsOpenAreDrawnUntilItIsAnother) {
  view->set_meshes({shown(open_sphere(24))});
  camera->look_along(CameraControl::Axis::top);
  frame_all();
  EXPECT_EQ(draw().count(is_orange), 0);
  view->show_open_edges(true);
  const Image open = draw("open");
  EXPECT_GT(open.count(is_orange), 50);
  view->show_open_edges(false);
  EXPECT_EQ(draw().count(is_orange), 0);
  view->show_open_edges(true);
  view->set_meshes({shown(sphere_mesh(24))});
  EXPECT_EQ(draw().count(is_orange), 0);
}

TEST(OpenEdges, AreThoseOfOneTriangleWhereverVerticesAreDoubled) {
  EXPECT_TRUE(open_edges(*sphere_mesh(8), 1000).empty());
  EXPECT_EQ(open_edges(*open_sphere(8), 1000).size(), 16U);
  TriangleMesh soup;
  const TriangleMesh whole = *sphere_mesh(8);
  for (const std::uint32_t vertex : whole.triangles) {
    soup.triangles.push_back(static_cast<std::uint32_t>(soup.points.size() / 3));
    soup.points.insert(soup.points.end(),
                       {whole.points[3 * vertex], whole.points[3 * vertex + 1], whole.points[3 * vertex + 2]});
  }
  EXPECT_TRUE(open_edges(soup, 1000).empty());
}

TEST(OpenEdges, AreNotHiddenByATriangleThatHasCollapsedAndNoMoreThanAskedFor) {
  TriangleMesh mesh;
  mesh.points = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  mesh.triangles = {0, 1, 2, 0, 1, 1};
  EXPECT_EQ(open_edges(mesh, 1000).size(), 3U);
  EXPECT_EQ(open_edges(mesh, 2).size(), 2U);
}

TEST_F(SceneSight, AModelThatIsHiddenHidesNoPlaceAndShowsNoOpenEdges) {
  view->set_meshes({shown(open_sphere(24))});
  camera->look_along(CameraControl::Axis::top);
  frame_all();
  view->show_open_edges(true);
  ASSERT_GT(draw().count(is_orange), 50);
  ASSERT_TRUE(view->direction_to_see({0, -1, 0}).has_value());
  ViewOptions options = view->options();
  options.model = false;
  view->set_options(options);
  EXPECT_EQ(draw().count(is_orange), 0);
  EXPECT_FALSE(view->direction_to_see({0, -1, 0}).has_value());
}

}  // namespace
}  // namespace cagewright::host
