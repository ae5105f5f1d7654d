// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "core/mesh/prepare.h"
#include "core/segment/segment.h"
#include "core/slide/across_limb.h"
#include "core/slide/plane_loops.h"
#include "core/tests/clicks.h"
#include "core/tests/expect_error.h"
#include "core/tests/meshes.h"
#include "core/tests/random_numbers.h"
#include "core/tests/shapes.h"

namespace cagewright {
namespace {

constexpr double degree = std::numbers::pi / 180;

Slide click(const Vector3& point) { return {"click", PointDefinition{point}}; }

// A solid of revolution about z: `radius` of z where it is positive, which it must be between -2 and 2 only.
Model solid_of_revolution(const std::function<double(double)>& radius) {
  const auto field = [&](const Vector3& p) { return p.head<2>().norm() - radius(p.z()); };
  return prepare_model(shapes::surface_of(field, {Vector3(-1.33, -1.31, -2.52), Vector3(1.34, 1.32, 2.51)}, 0.09));
}

TEST(SlideByPoint, IsPerpendicularToATubeOfAnyAxis) {
  Random random(1);
  for (int trial = 0; trial < 30; ++trial) {
    const shapes::Motion motion = shapes::random_motion(static_cast<unsigned>(trial), 1, 3);
    const Model model = prepare_model(shapes::moved(meshes::capsule(0.5, 4, 31, 40), motion));
    const double turn = random.uniform(0, 6.3);
    const Vector3 point = motion({0.5 * std::cos(turn), 0.5 * std::sin(turn), random.uniform(-1.4, 1.4)});
    const SlideOnModel placed = place_slide(model.mesh, model.edge_blocks, click(point), 0);
    EXPECT_LT(angle_between_lines(placed.ellipse.normal, motion.turn(Vector3::UnitZ())), 0.5 * degree);
    EXPECT_NEAR(placed.ellipse.u.norm(), 0.5, 0.01);
    EXPECT_LT(distance_to(placed.loop.points, point), 0.01);
  }
}

TEST(SlideByPoint, IsPerpendicularToATubeThatTapersOrBulges) {
  const Model cone = solid_of_revolution([](double z) { return std::abs(z) < 2 ? 0.6 - 0.2 * z : -1; });
  const Model spindle = solid_of_revolution([](double z) { return 0.7 - 0.25 * z * z; });
  Random random(2);
  for (int trial = 0; trial < 40; ++trial) {
    const double turn = random.uniform(0, 6.3), z = random.uniform(-1, 1);
    const auto at = [&](double radius) { return Vector3(radius * std::cos(turn), radius * std::sin(turn), z); };
    const Vector3 on_cone = place_slide(cone.mesh, cone.edge_blocks, click(at(0.6 - 0.2 * z)), 0).ellipse.normal;
    EXPECT_LT(angle_between_lines(on_cone, Vector3::UnitZ()), 2 * degree) << "cone at " << z;
    const Vector3 on_spindle =
        place_slide(spindle.mesh, spindle.edge_blocks, click(at(0.7 - 0.25 * z * z)), 0).ellipse.normal;
    EXPECT_LT(angle_between_lines(on_spindle, Vector3::UnitZ()), 4 * degree) << "spindle at " << z;
  }
}

TEST(SlideByPoint, FollowsABentTube) {
  const Model model = prepare_model(meshes::torus(3, 0.8, 120, 40));
  Random random(3);
  for (int trial = 0; trial < 40; ++trial) {
    const double around = random.uniform(0, 6.3), across = random.uniform(0, 6.3);
    const double radius = 3 + 0.8 * std::cos(across);
    const Vector3 point(radius * std::cos(around), radius * std::sin(around), 0.8 * std::sin(across));
    const SlideOnModel placed = place_slide(model.mesh, model.edge_blocks, click(point), 0);
    const Vector3 tangent(-std::sin(around), std::cos(around), 0);
    EXPECT_LT(angle_between_lines(placed.ellipse.normal, tangent), 3 * degree);
  }
}

TEST(SlideByPoint, CutsAnEllipsoidAcrossItsLongAxis) {
  IndexedMesh mesh = meshes::icosphere(4);
  mesh.points.col(0) *= 3;
  const Model model = prepare_model(mesh);
  Random random(4);
  for (int trial = 0; trial < 40; ++trial) {
    const double turn = random.uniform(0, 6.3), x = random.uniform(-1.5, 1.5), radius = std::sqrt(1 - x * x / 9);
    const Vector3 point(x, radius * std::cos(turn), radius * std::sin(turn));
    const Vector3 normal = place_slide(model.mesh, model.edge_blocks, click(point), 0).ellipse.normal;
    EXPECT_LT(angle_between_lines(normal, Vector3::UnitX()), 6 * degree) << x;
  }
}

// Across the limbs of a body, where they are limbs: as near to their axes as its bumps allow.
TEST(SlideByPoint, IsPerpendicularToTheLimbsOfABody) {
  for (const shapes::SlidBody& body : {shapes::limb(5), shapes::fork(2), shapes::figure()}) {
    const Model model = prepare_model(body.mesh);
    double sum = 0;
    int count = 0;
    for (const Slide& slide : body.slides) {
      const SlideOnModel across = place_slide(model.mesh, model.edge_blocks, slide, 0);
      for (Eigen::Index i = 0; i < across.loop.points.rows(); i += 3, ++count) {
        const SlideOnModel placed =
            place_slide(model.mesh, model.edge_blocks, click(across.loop.points.row(i).transpose()), 0);
        sum += angle_between_lines(placed.ellipse.normal, across.ellipse.normal);
        EXPECT_LT(placed.ellipse.u.norm(), 1.6 * across.ellipse.u.norm()) << body.name << ": of another limb, too";
      }
    }
    EXPECT_LT(sum / count, 8 * degree) << body.name;
  }
}

TEST(SlideByPoint, TurnsMovesAndScalesWithTheModel) {
  const IndexedMesh body = shapes::figure().mesh;
  const Model model = prepare_model(body);
  Random random(5);
  for (unsigned trial = 0; trial < 60; ++trial) {
    const shapes::Motion motion = shapes::random_motion(trial, trial % 2 == 0 ? 0.01 : 37, 5);
    const Model other = prepare_model(shapes::moved(body, motion));
    Vector3 point = random_point_on(model.mesh, random);
    if (trial % 3 == 0) point = model.mesh.point(OpenMesh::VertexHandle(random.below(500)));
    const Ellipse here = place_slide(model.mesh, model.edge_blocks, click(point), 0).ellipse;
    const Ellipse there = place_slide(other.mesh, other.edge_blocks, click(motion(point)), 0).ellipse;
    EXPECT_LT((there.normal - motion.turn(here.normal)).norm(), 1e-6) << trial;
    EXPECT_LT((there.center - motion(here.center)).norm(), 1e-6 * other.diagonal) << trial;
  }
}

TEST(SlideByPoint, HasTheLoopThroughItsPoint) {
  for (const shapes::SlidBody& body : shapes::slid_bodies()) {
    const Model model = prepare_model(body.mesh);
    Random random(6);
    for (int trial = 0; trial < 60; ++trial) {
      const Vector3 point = random_point_on(model.mesh, random);
      const SlideOnModel placed = place_slide(model.mesh, model.edge_blocks, click(point), 0);
      EXPECT_LT(distance_to(placed.loop.points, point), 1e-5 * model.diagonal) << body.name;
      EXPECT_GT(winding_number(placed.loop.points, placed.ellipse.center, placed.ellipse.normal), 0) << body.name;
      EXPECT_FALSE(placed.hollow);
    }
  }
}

TEST(SlideByPoint, MayLieOffTheSurfaceByALittle) {
  const Model model = prepare_model(meshes::capsule(0.5, 4, 32, 40));
  const SlideOnModel placed = place_slide(model.mesh, model.edge_blocks, click({0.6, 0.05, 0.3}), 0);
  EXPECT_LT(angle_between_lines(placed.ellipse.normal, Vector3::UnitZ()), 0.5 * degree);
  EXPECT_NEAR(placed.ellipse.center.z(), 0.3, 0.01);
}

TEST(SlideByPoint, PointsAwayFromTheMiddleOfTheModel) {
  const Model model = prepare_model(meshes::capsule(0.5, 4, 32, 40));
  EXPECT_GT(place_slide(model.mesh, model.edge_blocks, click({0.5, 0, 1.1}), 0).ellipse.normal.z(), 0.9);
  EXPECT_LT(place_slide(model.mesh, model.edge_blocks, click({0.5, 0, -1.1}), 0).ellipse.normal.z(), -0.9);
}

TEST(SlideByPoint, IsTheSameWhereOtherSlidesCutTheModel) {
  const Model model = prepare_model(meshes::capsule(0.5, 4, 32, 40));
  const Slide alone = click({0.5, 0, 0.31});
  const std::vector<Slide> slides = {{"a", PointNormalDefinition{{0, 0, 0.05}, {0.1, 0, 1}}},
                                     {"b", PointNormalDefinition{{0, 0, 0.55}, {0, 0.1, 1}}},
                                     alone};
  const Ellipse first = place_slide(model.mesh, model.edge_blocks, alone, 0).ellipse;
  const Ellipse third = segment(model, slides).ellipses[2];
  EXPECT_EQ(first.normal, third.normal);
  EXPECT_LT((first.center - third.center).norm(), 1e-12);
}

TEST(SlideByPoint, OnASphereGoesRoundIt) {
  const Model model = prepare_model(meshes::icosphere(4));
  Random random(7);
  for (int trial = 0; trial < 20; ++trial) {
    const SlideOnModel placed = place_slide(model.mesh, model.edge_blocks, click(random.direction()), 0);
    EXPECT_GT(placed.ellipse.v.norm(), 0.9);
  }
}

TEST(SlideByPoint, ThatCannotBeIsRefusedWithItsName) {
  const Model model = prepare_model(meshes::capsule(0.5, 4, 32, 40));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto place = [&](const Vector3& point) {
    place_slide(model.mesh, model.edge_blocks, {"wrist", PointDefinition{point}}, 7);
  };
  const Error far = expect_error(
      [&] {
        place({0, 3, 0});
      },
      ErrorCode::slide_misses_model, {"'wrist'", "(0, 3, 0)", "not on the model", "put it on the surface"});
  EXPECT_EQ(far.place().slide, 7u);
  EXPECT_EQ(far.place().point, Vector3(0, 3, 0));
  expect_error([&] { place({0, 0, 0}); }, ErrorCode::slide_misses_model, {"'wrist'"});
  expect_error([&] { place({0, nan, 0}); }, ErrorCode::slide_not_finite, {"'wrist'", "its point"});
  const Model hollow = prepare_model(meshes::hollow_sphere(3));
  const Error inside = expect_error(
      [&] {
        place_slide(hollow.mesh, hollow.edge_blocks, {"wrist", PointDefinition{{0.5, 0, 0}}}, 7);
      },
      ErrorCode::slide_not_enclosed, {"'wrist'", "(0.5, 0, 0)", "inside wall", "put it on the outside"});
  EXPECT_EQ(inside.place().slide, 7u);
  const std::vector<Slide> second = {{"elbow", PointDefinition{{0.5, 0, 0}}}, {"wrist", PointDefinition{{0, 3, 0}}}};
  EXPECT_EQ(expect_error([&] { segment(model, second); }, ErrorCode::slide_misses_model, {"'wrist'"}).place().slide,
            1u);
}

}  // namespace
}  // namespace cagewright
