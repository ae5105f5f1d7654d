// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/mesh/prepare.h"
#include "core/segment/cut_mesh.h"
#include "core/slide/plane_frame.h"
#include "core/slide/plane_loops.h"
#include "core/tests/expect_error.h"
#include "core/tests/meshes.h"
#include "core/tests/random_numbers.h"
#include "core/tests/shapes.h"

namespace cagewright {
namespace {

double signed_area(const Points& loop, const Vector3& normal) {
  Vector3 sum = Vector3::Zero();
  for (Eigen::Index i = 0; i < loop.rows(); ++i)
    sum += Vector3(loop.row(i) - loop.row(0)).cross(Vector3(loop.row((i + 1) % loop.rows()) - loop.row(0))) / 2;
  return sum.dot(normal.normalized());
}

// Closed and simple in the mesh: neighbours share a triangle, no edge is crossed twice, the ends lie on the right
// sides.
void expect_closed_loops(const HalfEdgeMesh& mesh, const std::vector<PlaneLoop>& loops, const Vector3& point,
                         const Vector3& normal) {
  std::set<int> edges;
  for (const PlaneLoop& loop : loops) {
    ASSERT_EQ(static_cast<std::size_t>(loop.points.rows()), loop.crossed.size());
    EXPECT_GE(loop.crossed.size(), 3u);
    for (std::size_t i = 0; i < loop.crossed.size(); ++i) {
      const auto h = loop.crossed[i], next = loop.crossed[(i + 1) % loop.crossed.size()];
      EXPECT_TRUE(edges.insert(mesh.edge_handle(h).idx()).second) << "an edge is crossed twice";
      const double from = normal.dot(mesh.point(mesh.from_vertex_handle(h)) - point);
      const double to = normal.dot(mesh.point(mesh.to_vertex_handle(h)) - point);
      EXPECT_LT(from, 0);
      EXPECT_GE(to, 0);
      const auto right = mesh.face_handle(mesh.opposite_halfedge_handle(h));
      EXPECT_TRUE(mesh.face_handle(next) == right) << "the next crossing belongs to the triangle on the right";
    }
  }
  int crossing = 0;
  for (const auto e : mesh.edges()) {
    const auto h = mesh.halfedge_handle(e, 0);
    crossing += (normal.dot(mesh.point(mesh.from_vertex_handle(h)) - point) >= 0) !=
                (normal.dot(mesh.point(mesh.to_vertex_handle(h)) - point) >= 0);
  }
  EXPECT_EQ(static_cast<int>(edges.size()), crossing) << "every crossed edge belongs to a loop";
}

TEST(PlaneLoops, CutASphereInACircleOfTheRightArea) {
  const Model model = prepare_model(meshes::icosphere(4));
  Random random(1);
  for (int trial = 0; trial < 50; ++trial) {
    const Vector3 normal = random.direction();
    const double height = random.uniform(-0.9, 0.9);
    const auto loops = plane_loops(model.mesh, model.edge_blocks, height * normal, 7 * normal);
    ASSERT_EQ(loops.size(), 1u);
    expect_closed_loops(model.mesh, loops, height * normal, normal);
    EXPECT_NEAR(signed_area(loops[0].points, normal) / (M_PI * (1 - height * height)), 1, 0.02);
  }
}

TEST(PlaneLoops, CutATorusTwice) {
  const Model model = prepare_model(meshes::torus(3, 1, 150, 100));
  const auto across = plane_loops(model.mesh, model.edge_blocks, {0.013, 0, 0}, {1, 0.001, 0});
  ASSERT_EQ(across.size(), 2u);
  expect_closed_loops(model.mesh, across, {0.013, 0, 0}, {1, 0.001, 0});
  for (const PlaneLoop& loop : across) EXPECT_NEAR(signed_area(loop.points, {1, 0.001, 0}) / M_PI, 1, 0.01);
  const auto level = plane_loops(model.mesh, model.edge_blocks, {0, 0, 0.011}, {0, 0, 1});
  ASSERT_EQ(level.size(), 2u);
  double outer = signed_area(level[0].points, {0, 0, 1}), inner = signed_area(level[1].points, {0, 0, 1});
  if (outer < inner) std::swap(outer, inner);
  EXPECT_NEAR(outer / (16 * M_PI), 1, 0.01) << "round the material: counter-clockwise";
  EXPECT_NEAR(inner / (-4 * M_PI), 1, 0.01) << "round the hole: clockwise";
}

TEST(PlaneLoops, OfAModelThatWasCutBeforeMissNoEdge) {
  const Model model = prepare_model(meshes::icosphere(4));
  Random random(5);
  CutMesh cut(model);
  const std::vector<std::string> names{"a", "b", "c"};
  for (int k = 0; k < 3; ++k) {  // level, so that they do not meet
    const Vector3 normal = Vector3::UnitZ() + 0.05 * random.direction();
    const auto loops = plane_loops(cut.mesh(), cut.edge_blocks(), {0, 0, 0.3 * k - 0.31}, normal);
    ASSERT_EQ(loops.size(), 1u);
    cut.cut(loops.front(), k, names);
    for (int trial = 0; trial < 20; ++trial) {
      const Vector3 across = random.direction(), point = 0.8 * random.direction();
      expect_closed_loops(cut.mesh(), plane_loops(cut.mesh(), cut.edge_blocks(), point, across), point, across);
    }
  }
}

TEST(PlaneLoops, StayClosedWhereThePlaneHoldsVerticesEdgesOrWholeTriangles) {
  const Model box = prepare_model(meshes::box({0, 0, 0}, {1, 1, 1}));
  const Model plate = prepare_model(meshes::perforated_plate(2));
  const Model capsule = prepare_model(meshes::capsule(1, 2, 16, 4));
  Random random(2);
  for (const Model* model : {&box, &plate, &capsule})
    for (int trial = 0; trial < 200; ++trial) {
      const auto vertex = [&] {
        return model->mesh.point(OpenMesh::VertexHandle(random.below(static_cast<int>(model->mesh.n_vertices()))));
      };
      const Vector3 a = vertex();
      Vector3 normal = trial % 2 ? Vector3((vertex() - a).cross(vertex() - a)) : Vector3::Unit(trial % 3);
      if (normal.norm() < 1e-9) continue;
      const auto loops = plane_loops(model->mesh, model->edge_blocks, a, normal);
      std::size_t points = 0;
      for (const PlaneLoop& loop : loops) {
        points += loop.crossed.size();
        EXPECT_GE(loop.crossed.size(), 3u);
        EXPECT_LT(((loop.points.rowwise() - a.transpose()) * normal.normalized()).cwiseAbs().maxCoeff(), 1e-12);
      }
      std::set<int> edges;
      for (const PlaneLoop& loop : loops)
        for (const auto h : loop.crossed) {
          edges.insert(model->mesh.edge_handle(h).idx());
          if (trial % 2) continue;  // along an axis heights are exact
          EXPECT_LT(normal.dot(model->mesh.point(model->mesh.from_vertex_handle(h)) - a), -1e-12);
          EXPECT_GE(normal.dot(model->mesh.point(model->mesh.to_vertex_handle(h)) - a), -1e-12) << "on it is ahead";
        }
      EXPECT_EQ(edges.size(), points);
    }
}

TEST(WindingNumber, CountsTurnsExactlyHoweverNearTheLoop) {
  const Model model = prepare_model(meshes::icosphere(3));
  Random random(3);
  for (int trial = 0; trial < 100; ++trial) {
    const Vector3 normal = random.direction();
    const Points loop = plane_loops(model.mesh, model.edge_blocks, 0.1 * normal, normal).at(0).points;
    const int i = random.below(static_cast<int>(loop.rows()));
    const Vector3 a = loop.row(i), b = loop.row((i + 1) % loop.rows()), middle = (a + b) / 2;
    const Vector3 outward = (b - a).cross(normal).normalized();
    for (const double step : {1e-1, 1e-6, 1e-12}) {
      EXPECT_EQ(winding_number(loop, middle - step * outward, normal), 1) << step;
      EXPECT_EQ(winding_number(loop, middle + step * outward, normal), 0) << step;
      EXPECT_EQ(winding_number(loop, middle - step * outward, -normal), -1) << step;
    }
    const Points reversed = loop.colwise().reverse();
    EXPECT_EQ(winding_number(reversed, 0.1 * normal, normal), -1);
  }
}

TEST(PlaceSlide, TakesTheInnermostLoopRoundTheCenter) {
  const Model model = prepare_model(meshes::torus(3, 1, 60, 40));
  const Slide at_limb{"limb", PointNormalDefinition{{3, 0, 0.01}, {0, 1, 0.02}}};
  const SlideOnModel limb = place_slide(model.mesh, model.edge_blocks, at_limb, 0);
  EXPECT_LT((limb.ellipse.center - Vector3(3, 0, 0)).norm(), 0.02);
  EXPECT_NEAR(limb.ellipse.u.norm(), 1, 0.05);
  // One body inside another's loop: the nearer one round the centre is cut.
  const Model nested = prepare_model(
      meshes::together(meshes::hollow_sphere(3), meshes::moved(meshes::icosphere(3), 0.3, Vector3::Zero())));
  const Slide inner{"inner", EllipseDefinition{{0.01, 0, 0.02}, {1, 0, 0}, {0, 1, 0}}};
  EXPECT_NEAR(signed_area(place_slide(nested.mesh, nested.edge_blocks, inner, 0).loop.points, {0, 0, 1}), 0.09 * M_PI,
              0.01);
}

TEST(PlaceSlide, TakesTheNearestLoopWhereNoneGoesRoundThePoint) {
  const shapes::SlidBody body = shapes::figure();
  const Model model = prepare_model(body.mesh);
  for (const double x : {0.9, -0.9}) {
    const Slide beside{"beside", PointNormalDefinition{{x, 0.02, -1.2}, {0, 0, 1}}};
    EXPECT_GT(place_slide(model.mesh, model.edge_blocks, beside, 0).ellipse.center.x() * x, 0.2)
        << "the leg on that side";
  }
}

TEST(PlaceSlide, PutsTheCenterOfACrescentInsideIt) {
  // A bent tube cut lengthwise: the centroid of the crescent lies outside of it.
  std::vector<shapes::Tube> tubes;
  for (int i = 0; i < 8; ++i) {
    const auto at = [](int k) { return Vector3(2 * std::cos(0.45 * k), 0.05, 2 * std::sin(0.45 * k)); };
    tubes.push_back({at(i), at(i + 1), 0.3});
  }
  const Model model = prepare_model(shapes::body_of(tubes, 0.11));
  const Slide lengthwise{"crescent", PointNormalDefinition{{2, 0.05, 0}, {0, 1, 0}}};
  const SlideOnModel placed = place_slide(model.mesh, model.edge_blocks, lengthwise, 0);
  EXPECT_EQ(winding_number(placed.loop.points, placed.ellipse.center, placed.ellipse.normal), 1);
}

TEST(PlaceSlide, RefusesSlidesThatMissTheModelOrAreNotEnclosed) {
  const Model model = prepare_model(meshes::torus(3, 1, 60, 40));
  const Slide far_plane{"far", PointNormalDefinition{{0, 0, 9}, {0, 0, 1}}};
  const Error missed = expect_error([&] { place_slide(model.mesh, model.edge_blocks, far_plane, 3); },
                                    ErrorCode::slide_misses_model, {"'far'", "misses the model", "(0, 0, 9)"});
  EXPECT_EQ(missed.place().slide, 3u);
  const Slide far_ellipse{"away", EllipseDefinition{{0, 0, 9}, {1, 0, 0}, {0, 1, 0}}};
  expect_error([&] { place_slide(model.mesh, model.edge_blocks, far_ellipse, 1); }, ErrorCode::slide_misses_model,
               {"'away'"});
  const Slide in_hole{"hole", EllipseDefinition{{0, 0, 0.1}, {1, 0, 0}, {0, 0.1, 1}}};
  const Error open = expect_error([&] { place_slide(model.mesh, model.edge_blocks, in_hole, 2); },
                                  ErrorCode::slide_not_enclosed, {"'hole'", "(0, 0, 0.1)", "inside the limb"});
  EXPECT_EQ(open.place().slide, 2u);
  EXPECT_TRUE(open.place().point);
  const Slide bad{"bad", EllipseDefinition{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}};
  EXPECT_EQ(
      expect_error([&] { place_slide(model.mesh, model.edge_blocks, bad, 5); }, ErrorCode::slide_degenerate, {"'bad'"})
          .place()
          .slide,
      5u);
}

}  // namespace
}  // namespace cagewright
