// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/enclose/certificate.h"
#include "core/enclose/triangle_intersection.h"
#include "core/enclose/winding.h"
#include "core/pipeline/pipeline.h"
#include "core/tests/meshes.h"
#include "core/tests/random_numbers.h"
#include "core/tests/shapes.h"

namespace cagewright {
namespace {

using Pairs = std::vector<std::array<int, 2>>;

Triangle3 corners(const IndexedMesh& mesh, int t) {
  return {mesh.points.row(mesh.triangles(t, 0)), mesh.points.row(mesh.triangles(t, 1)),
          mesh.points.row(mesh.triangles(t, 2))};
}

// The generalised winding number by solid angles (van Oosterom and Strackee), for points that are not on the mesh.
double winding_by_angles(const IndexedMesh& mesh, const Vector3& p) {
  double sum = 0;
  for (int t = 0; t < static_cast<int>(mesh.triangles.rows()); ++t) {
    const Triangle3 c = corners(mesh, t);
    const Vector3 x = c[0] - p, y = c[1] - p, z = c[2] - p;
    sum += 2 * std::atan2(x.dot(y.cross(z)), x.norm() * y.norm() * z.norm() + x.dot(y) * z.norm() +
                                                 y.dot(z) * x.norm() + z.dot(x) * y.norm());
  }
  return sum / (4 * std::numbers::pi);
}

Pairs self_intersections_by_all_pairs(const IndexedMesh& cage) {
  Pairs pairs;
  for (int s = 0; s < static_cast<int>(cage.triangles.rows()); ++s)
    for (int t = s + 1; t < static_cast<int>(cage.triangles.rows()); ++t)
      if (triangles_of_mesh_meet(cage, s, t)) pairs.push_back({s, t});
  return pairs;
}

Pairs model_intersections_by_all_pairs(const IndexedMesh& model, const IndexedMesh& cage) {
  Pairs pairs;
  for (int t = 0; t < static_cast<int>(model.triangles.rows()); ++t)
    for (int wall = 0; wall < static_cast<int>(cage.triangles.rows()); ++wall)
      if (triangles_meet(corners(model, t), corners(cage, wall))) {
        pairs.push_back({t, wall});
        break;
      }
  return pairs;
}

void expect_as_by_all_pairs(const IndexedMesh& model, const IndexedMesh& cage) {
  const Certificate certificate = certify(model, cage);
  EXPECT_EQ(certificate.self_intersections, self_intersections_by_all_pairs(cage));
  EXPECT_EQ(certificate.model_cage_intersections, model_intersections_by_all_pairs(model, cage));
  std::vector<int> outside;
  for (int v = 0; v < static_cast<int>(model.points.rows()); ++v)
    if (winding_by_angles(cage, model.points.row(v)) < 0.5) outside.push_back(v);
  EXPECT_EQ(certificate.vertices_outside, outside);
}

IndexedMesh shaken(IndexedMesh mesh, Random& random, double most) {
  for (Eigen::Index v = 0; v < mesh.points.rows(); ++v)
    mesh.points.row(v) += random.uniform(0, most) * random.direction().transpose();
  return mesh;
}

TEST(Certificate, IsGivenToABoxRoundABall) {
  const Certificate certificate = certify(meshes::icosphere(3), meshes::box({-1.1, -1.1, -1.1}, {1.1, 1.1, 1.1}));
  EXPECT_TRUE(certificate.encloses());
  EXPECT_TRUE(certificate.closed);
}

TEST(Certificate, TakesTouchingForMeeting) {
  const IndexedMesh model = meshes::box({-1, -1, -1}, {1, 1, 1});
  const auto round = [&](double size) { return certify(model, meshes::box({-2, -2, -2}, {2, 2, size})); };
  EXPECT_TRUE(round(std::nextafter(1.0, 2.0)).encloses());
  const Certificate touching = round(1);
  EXPECT_FALSE(touching.encloses());
  EXPECT_FALSE(touching.model_cage_intersections.empty());
  EXPECT_EQ(touching.vertices_outside.size(), 4u) << "on the cage is not inside";
}

TEST(Certificate, NamesWhatIsWrongWithTheCageItself) {
  const IndexedMesh ball = meshes::icosphere(1);
  const IndexedMesh box = meshes::box({-2, -2, -2}, {2, 2, 2});
  EXPECT_FALSE(certify(ball, meshes::without_triangle(box, 3)).closed);
  EXPECT_FALSE(certify(ball, meshes::inside_out(box)).closed);
  IndexedMesh flat = box;
  flat.points.row(0) = (flat.points.row(1) + flat.points.row(2)) / 2;
  EXPECT_FALSE(certify(ball, flat).encloses());
  const IndexedMesh two = meshes::together(box, meshes::moved(box, 1, {3.5, 0, 0}));
  const Certificate crossed = certify(ball, two);
  EXPECT_TRUE(crossed.closed);
  EXPECT_FALSE(crossed.self_intersections.empty());
  EXPECT_TRUE(crossed.vertices_outside.empty());
  EXPECT_FALSE(crossed.encloses());
  EXPECT_FALSE(certify(ball, meshes::bow_tie()).closed);
}

TEST(Certificate, JudgesOutwardnessByComponent) {
  const IndexedMesh ball = meshes::icosphere(1);
  const IndexedMesh box = meshes::box({-3, -3, -3}, {3, 3, 3});
  const IndexedMesh small = meshes::moved(meshes::icosphere(1), 1, {9, 0, 0});
  EXPECT_TRUE(certify(ball, meshes::together(box, small)).encloses());
  EXPECT_FALSE(certify(ball, meshes::together(box, meshes::inside_out(small))).closed) << "outweighed by the box";
  const IndexedMesh cavity = meshes::inside_out(meshes::moved(meshes::icosphere(1), 0.2, {2.5, 2.5, 2.5}));
  EXPECT_TRUE(certify(ball, meshes::together(box, cavity)).encloses()) << "a cavity beside the model";
}

TEST(Certificate, FindsEveryComponentThatIsOutside) {
  const IndexedMesh ball = meshes::icosphere(1);
  const IndexedMesh far = meshes::together(ball, meshes::moved(ball, 1, {9, 0, 0}));
  const Certificate certificate = certify(far, meshes::box({-2, -2, -2}, {2, 2, 2}));
  EXPECT_TRUE(certificate.model_cage_intersections.empty());
  EXPECT_EQ(certificate.vertices_outside.size(), static_cast<std::size_t>(ball.points.rows()));
  EXPECT_EQ(certificate.vertices_outside.front(), ball.points.rows());
}

TEST(Certificate, AgreesWithAllPairsOnShakenCages) {
  Random random(5);
  int bounding = 0, crossing_themselves = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const IndexedMesh model = shaken(meshes::icosphere(2), random, 0.02);
    const double size = random.uniform(1.0, 1.7);
    const IndexedMesh cage =
        shaken(meshes::moved(meshes::icosphere(1), size, {0, 0, 0}), random, random.uniform(0, 0.9 * size));
    expect_as_by_all_pairs(model, cage);
    const Certificate certificate = certify(model, cage);
    bounding += certificate.encloses();
    crossing_themselves += !certificate.self_intersections.empty();
  }
  EXPECT_GT(bounding, 10);
  EXPECT_GT(crossing_themselves, 30);
}

TEST(Certificate, AgreesWithAllPairsOnCagesOfThePipeline) {
  for (const shapes::SlidBody& body : shapes::slid_bodies()) {
    SCOPED_TRACE(body.name);
    const PipelineResult result = make_cage(prepare_model(body.mesh), body.slides, {});
    expect_as_by_all_pairs(body.mesh, {result.cage->points, result.cage->triangles});
  }
}

TEST(Certificate, IsTheSameForAnyNumberOfThreads) {
  const shapes::SlidBody body = shapes::figure();
  const PipelineResult result = make_cage(prepare_model(body.mesh), body.slides, {});
  const IndexedMesh cage = {result.cage->points, result.cage->triangles};
  const Certificate one = certify(body.mesh, cage, 1);
  EXPECT_FALSE(one.vertices_outside.empty() && one.model_cage_intersections.empty());
  for (const unsigned threads : {2u, 5u}) {
    const Certificate many = certify(body.mesh, cage, threads);
    EXPECT_EQ(one.self_intersections, many.self_intersections);
    EXPECT_EQ(one.model_cage_intersections, many.model_cage_intersections);
    EXPECT_EQ(one.vertices_outside, many.vertices_outside);
  }
}

TEST(Winding, IsExactOnAGridWhereRaysHitCornersAndEdges) {
  const IndexedMesh mesh = meshes::together(meshes::box({0, 0, 0}, {4, 4, 4}), meshes::box({1, 1, 1}, {3, 3, 3}));
  const BoxTree tree(mesh);
  const Winding winding(mesh, tree);
  const auto depth = [](const Vector3& p, double low, double high) {
    const double inside = std::min((p.array() - low).minCoeff(), (high - p.array()).minCoeff());
    return inside > 0 ? 1 : inside == 0 ? 0 : -1;  // inside, on, outside
  };
  for (int i = 0; i < 9 * 9 * 9; ++i) {
    const Vector3 p = 0.5 * Vector3(i % 9, i / 9 % 9, i / 81);
    const int outer = depth(p, 0, 4), inner = depth(p, 1, 3);
    const auto number = winding.of(p);
    ASSERT_EQ(number.has_value(), outer != 0 && inner != 0) << p.transpose();
    if (number) {
      ASSERT_EQ(*number, (outer > 0) + (inner > 0)) << p.transpose();
    }
  }
}

}  // namespace
}  // namespace cagewright
