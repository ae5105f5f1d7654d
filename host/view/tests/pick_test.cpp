// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <vtkCamera.h>

#include <cmath>
#include <random>

#include "host/view/tests/window_fixture.h"
#include "host/view/window/scene_view.h"

namespace cagewright::host {
namespace {

using What = Hit::What;

class Pick : public Window {
 protected:
  std::array<double, 2> middle() const { return {320, 240}; }
  Hit pick_at(const Point3& point, bool slides_first) const {
    const auto [x, y] = view->to_display(point);
    return view->pick(x, y, slides_first);
  }
};

// Turned about z by half a right angle, stretched unevenly, mirrored, moved.
Matrix4 odd_transform() {
  const double c = std::sqrt(0.5);
  return product(translation(3, -1, 2),
                 product({c, -c, 0, 0, c, c, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}, scaling(-2, 0.5, 1.3)));
}

TEST_F(Pick, ModelPointsComeBackToTheirPixelUnderAnyTransformAndProjection) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> x(0, 640), y(0, 480);
  for (const Matrix4& to_scene : {translation(0, 0, 0), odd_transform()}) {
    ShownMesh mesh = shown(sphere_mesh(20), 4);
    mesh.to_scene = to_scene;
    view->set_meshes({mesh});
    frame_all();
    for (const bool orthographic : {false, true}) {
      camera->set_orthographic(orthographic);
      int hits = 0;
      for (int i = 0; i < 300; ++i) {
        const std::array<double, 2> at{x(random), y(random)};
        const auto hit = view->pick_model(at[0], at[1]);
        if (!hit) continue;
        ++hits;
        EXPECT_EQ(hit->what, What::model);
        EXPECT_EQ(hit->node, 4);
        const auto seen = view->to_display(hit->point);
        EXPECT_NEAR(seen[0], at[0], 0.01);
        EXPECT_NEAR(seen[1], at[1], 0.01);
        // On the sphere, in its own space; the triangle's normal there; facing the ray.
        const double radius = std::hypot(hit->point[0], hit->point[1], hit->point[2]);
        EXPECT_NEAR(radius, 1, 0.02);
        double across = 0, towards = 0, length = 0;
        const Ray ray = view->ray(at[0], at[1]);
        for (std::size_t k = 0; k < 3; ++k) {
          across += hit->normal[k] * hit->point[k] / radius;
          towards += hit->normal[k] * ray.direction[k];
          length += hit->normal[k] * hit->normal[k];
        }
        EXPECT_GT(across, 0.98);
        EXPECT_LT(towards, 0);
        EXPECT_NEAR(length, 1, 1e-12);
      }
      EXPECT_GT(hits, 30);
    }
  }
}

TEST_F(Pick, RaysAreInTheActiveMeshsSpaceAndGoThroughWhatIsThere) {
  ShownMesh mesh = shown(sphere_mesh(8));
  mesh.to_scene = odd_transform();
  view->set_meshes({mesh});
  frame_all();
  const Point3 point{0.3, -0.4, 0.2};
  const auto [x, y] = view->to_display(point);
  const Ray ray = view->ray(x, y);
  double along = 0, length = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    along += (point[k] - ray.origin[k]) * ray.direction[k];
    length += ray.direction[k] * ray.direction[k];
  }
  EXPECT_NEAR(length, 1, 1e-12);
  EXPECT_GT(along, 0);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(ray.origin[k] + along * ray.direction[k], point[k], 1e-9);
}

TEST_F(Pick, OtherMeshesArePickedInTheirOwnSpaceButNotByPickModel) {
  ShownMesh other = shown(box_mesh(1), 9, false);
  other.to_scene = product(translation(4, 0, 0), scaling(0.5, 0.5, 0.5));
  view->set_meshes({shown(box_mesh(1), 2), other});
  frame_all();
  camera->look_along(CameraControl::Axis::front);
  const auto [x, y] = view->to_display({4, 0, 0.5});  // the other's front in the active one's space, the scene's
  const Hit hit = view->pick(x, y, true);
  EXPECT_EQ(hit.what, What::model);
  EXPECT_EQ(hit.node, 9);
  EXPECT_NEAR(hit.point[0], 0, 1e-6);
  EXPECT_NEAR(hit.point[2], 1, 1e-6);
  EXPECT_EQ(hit.normal, (Point3{0, 0, 1}));
  EXPECT_FALSE(view->pick_model(x, y).has_value());
  EXPECT_EQ(pick_at({0, 0, 1}, true).node, 2);
}

TEST_F(Pick, TheNearestOfSeveralMeshesIsMeant) {
  ShownMesh behind = shown(box_mesh(1), 9, false);
  behind.to_scene = translation(0, 0, -5);
  view->set_meshes({behind, shown(box_mesh(0.5), 2)});
  frame_all();
  camera->look_along(CameraControl::Axis::front);
  EXPECT_EQ(pick_at({0.2, 0.1, 0.5}, true).node, 2);
  camera->look_along(CameraControl::Axis::back);
  EXPECT_EQ(pick_at({0.2, 0.1, 0.5}, true).node, 9);
}

TEST_F(Pick, SlidesArePickedWithinSixPixelsOfTheirOutline) {
  view->set_meshes({shown(sphere_mesh(24))});
  view->set_slides({level_slide(3, 1.3), level_slide(8, 1.3, 0.5)});
  frame_all();
  const auto [x, y] = view->to_display({0, 0, 1.3});
  const Hit hit = view->pick(x, y - 5, true);
  EXPECT_EQ(hit.what, What::slide);
  EXPECT_EQ(hit.slide, 3);
  EXPECT_NEAR(std::hypot(hit.point[0], hit.point[2]), 1.3, 0.01);
  EXPECT_NE(view->pick(x, y - 9, true).what, What::slide);
  EXPECT_EQ(pick_at({0, 0.5, 1.3}, true).slide, 8);
  view->set_slides({level_slide(-1, 1.3)});
  EXPECT_EQ(view->pick(x, y, true).what, What::model) << "one that is only shown has no id to be found by";
  view->set_slides({level_slide(3, 1.3)});
  ViewOptions options = view->options();
  options.slides = false;
  view->set_options(options);
  EXPECT_EQ(view->pick(x, y, true).what, What::model);
}

TEST_F(Pick, HiddenSlidesArePickedOnlyWhereSlidesComeFirst) {
  view->set_meshes({shown(sphere_mesh(24))});
  view->set_slides({level_slide(3, 0.6)});
  frame_all();
  const Point3 on_slide{0, 0, 0.6};
  EXPECT_EQ(pick_at(on_slide, true).what, What::slide);
  EXPECT_EQ(pick_at(on_slide, false).what, What::model);
  view->set_slides({level_slide(3, 1.2)});
  EXPECT_EQ(pick_at({0, 0, 1.2}, false).what, What::slide);
  EXPECT_EQ(pick_at({0, 0, -1.2}, false).what, What::model);
}

TEST_F(Pick, TheCageIsPickedWhereNothingElseIs) {
  view->set_meshes({shown(sphere_mesh(24))});
  const ShownCage cage = box_cage(1.3);
  view->set_cage(&cage);
  frame_all();
  camera->look_along(CameraControl::Axis::front);
  const Hit corner = pick_at({1.25, 1.2, 1.3}, true);
  EXPECT_EQ(corner.what, What::cage);
  EXPECT_NEAR(corner.point[2], 1.3, 1e-6);
  EXPECT_EQ(corner.normal, (Point3{0, 0, 1}));
  EXPECT_EQ(pick_at({0, 0, 1}, true).what, What::model);
  EXPECT_EQ(view->pick(2, 2, true).what, What::nothing);
  view->set_cage(nullptr);
  EXPECT_EQ(pick_at({1.25, 1.2, 1.3}, true).what, What::nothing);
}

TEST_F(Pick, OrthographicViewsPickWhatIsBehindTheEyeToo) {
  view->set_meshes({shown(box_mesh(1))});
  frame_all();
  camera->look_along(CameraControl::Axis::front);
  camera->set_orthographic(true);
  while (renderer->GetActiveCamera()->GetPosition()[2] > 0.5) camera->dolly(30);
  const auto hit = view->pick_model(320, 240);
  ASSERT_TRUE(hit.has_value());
  EXPECT_NEAR(hit->point[2], 1, 1e-9) << "the front face, which is what is drawn";
}

TEST_F(Pick, AnEmptySceneAndFlatTransformsAreMissed) {
  EXPECT_EQ(view->pick(320, 240, true).what, What::nothing);
  EXPECT_FALSE(view->pick_model(320, 240).has_value());
  ShownMesh flat = shown(box_mesh(1));
  flat.to_scene = scaling(1, 0, 1);
  view->set_meshes({flat, shown(std::make_shared<TriangleMesh>(), 1, false)});
  EXPECT_EQ(view->pick(320, 240, true).what, What::nothing);
  EXPECT_TRUE(std::isfinite(view->ray(320, 240).direction[0]));
  draw();
}

}  // namespace
}  // namespace cagewright::host
