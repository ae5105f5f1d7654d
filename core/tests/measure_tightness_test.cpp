// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/enclose/triangle_distance.h"
#include "core/measure/surface_samples.h"
#include "core/measure/tightness.h"
#include "core/tests/expect_error.h"
#include "core/tests/meshes.h"
#include "core/tests/random_numbers.h"
#include "core/tests/shapes.h"

namespace cagewright {
namespace {

Tightness tightness_of(const IndexedMesh& model, const IndexedMesh& cage, unsigned threads = 0) {
  return measure_tightness(MeasuredModel(model, threads), cage, certify(model, cage, threads), threads);
}

Triangle3 corners(const IndexedMesh& mesh, Eigen::Index t) {
  return {mesh.points.row(mesh.triangles(t, 0)), mesh.points.row(mesh.triangles(t, 1)),
          mesh.points.row(mesh.triangles(t, 2))};
}

double area_of(const Triangle3& c) { return (c[1] - c[0]).cross(c[2] - c[0]).norm() / 2; }

IndexedMesh cube(double half) { return meshes::box(Vector3::Constant(-half), Vector3::Constant(half)); }
double diagonal_of(const IndexedMesh& mesh) {
  return (mesh.points.colwise().maxCoeff() - mesh.points.colwise().minCoeff()).norm();
}

IndexedMesh shaken(IndexedMesh mesh, unsigned seed, double most) {
  Random random(seed);
  for (Eigen::Index v = 0; v < mesh.points.rows(); ++v)
    mesh.points.row(v) += random.uniform(0, most) * random.direction().transpose();
  return mesh;
}

void expect_near(const Tightness& a, const Tightness& b, double scale, double tolerance) {
  ASSERT_EQ(a.volume_ratio.has_value(), b.volume_ratio.has_value());
  if (a.volume_ratio) {
    EXPECT_NEAR(*a.volume_ratio, *b.volume_ratio, tolerance * std::abs(*b.volume_ratio));
    EXPECT_NEAR(*a.coverage, *b.coverage, tolerance);
  }
  EXPECT_NEAR(a.mean_gap * scale, b.mean_gap, tolerance);
  EXPECT_NEAR(a.max_gap * scale, b.max_gap, tolerance);
  EXPECT_NEAR(a.clearance * scale, b.clearance, tolerance);
}

TEST(Tightness, IsExactForACubeInABox) {
  for (const Vector3& half : {Vector3(3, 3, 3), Vector3(2, 3, 5)}) {
    const Tightness tightness = tightness_of(cube(1), meshes::box(-half, half));
    const double diagonal = 2 * std::sqrt(3);
    EXPECT_NEAR(tightness.volume_ratio.value(), half.prod(), 1e-13 * half.prod());
    EXPECT_EQ(tightness.coverage.value(), 1);
    EXPECT_NEAR(tightness.clearance, (half.minCoeff() - 1) / diagonal, 1e-15);
    // The rule of SurfaceSamples, on one of the two right triangles of each face: the other is its mirror image.
    double sum = 0, area = 0, most = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const double height = half[axis] - 1, side = half[(axis + 1) % 3], other = half[(axis + 2) % 3];
      area += side * other;
      for (int i = 0; i < 12; ++i)
        for (int j = 0; i + j < 12; ++j) {
          const double u = side * (2 * (i + 1.0 / 3) / 12 - 1), v = other * (2 * (j + 1.0 / 3) / 12 - 1);
          const double gap = std::hypot(height, std::max(std::abs(u) - 1, 0.0), std::max(std::abs(v) - 1, 0.0));
          sum += side * other * gap / 78;
          most = std::max(most, gap);
        }
    }
    EXPECT_NEAR(tightness.mean_gap, sum / area / diagonal, 1e-14);
    EXPECT_NEAR(tightness.max_gap, most / diagonal, 1e-14);
  }
}

TEST(Tightness, ComesNearTheIntegralsOverTheCage) {
  const Tightness tightness = tightness_of(cube(1), cube(3));
  double sum = 0;
  const int n = 1000;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const double x = 3 * (i + 0.5) / n, y = 3 * (j + 0.5) / n;
      sum += std::hypot(2, std::max(x - 1, 0.0), std::max(y - 1, 0.0));
    }
  const double diagonal = 2 * std::sqrt(3);
  EXPECT_NEAR(tightness.mean_gap * diagonal, sum / n / n, 0.02 * sum / n / n);
  EXPECT_LT(tightness.max_gap * diagonal, 2 * std::sqrt(3));
  EXPECT_GT(tightness.max_gap * diagonal, 0.93 * 2 * std::sqrt(3));
}

TEST(Tightness, SeesTheOffsetOfABall) {
  for (const double offset : {1e-6, 0.01, 0.5}) {
    const IndexedMesh ball = meshes::icosphere(4);
    const Tightness tightness = tightness_of(ball, meshes::moved(ball, 1 + offset, Vector3::Zero()));
    const double diagonal = diagonal_of(ball);
    EXPECT_NEAR(tightness.mean_gap * diagonal, offset, 0.005 * offset);
    EXPECT_NEAR(tightness.max_gap * diagonal, offset, 0.005 * offset);
    EXPECT_NEAR(tightness.clearance * diagonal, offset, 0.005 * offset);
    EXPECT_NEAR(tightness.volume_ratio.value(), std::pow(1 + offset, 3), 1e-12);
  }
}

TEST(Tightness, StaysUnderRigidMotionsAndScales) {
  const IndexedMesh model = shaken(meshes::icosphere(3), 3, 0.05), cage = shaken(meshes::icosphere(1), 4, 0.1);
  for (const double half : {1.3, 0.9}) {  // round the model, and through it
    const IndexedMesh grown = meshes::moved(cage, half, {0.02, 0.01, -0.03});
    const Tightness here = tightness_of(model, grown);
    for (unsigned seed = 1; seed <= 10; ++seed) {
      const shapes::Motion motion = shapes::random_motion(seed, seed % 2 ? 1e-3 : 1e4, 100);
      const IndexedMesh there = shapes::moved(model, motion);
      const double scale = diagonal_of(there) / motion.scale / diagonal_of(model);
      expect_near(tightness_of(there, shapes::moved(grown, motion)), here, scale, 1e-8);
    }
  }
}

TEST(Tightness, HoldsForModelsThatAreHugeOrTiny) {
  const IndexedMesh model = meshes::icosphere(2), cage = cube(1.2);
  const Tightness plain = tightness_of(model, cage);
  for (const double scale : {1e-120, 1e120}) {
    const auto scaled = [&](const IndexedMesh& mesh) { return meshes::moved(mesh, scale, Vector3::Zero()); };
    expect_near(tightness_of(scaled(model), scaled(cage)), plain, 1, 1e-12);
  }
}

TEST(Tightness, DoesNotDependOnVertexAndTriangleOrder) {
  const IndexedMesh model = shaken(meshes::icosphere(3), 5, 0.05), cage = shaken(meshes::icosphere(1), 6, 0.1);
  const Tightness plain = tightness_of(model, cage);
  EXPECT_GT(plain.coverage.value(), 0);
  EXPECT_LT(plain.coverage.value(), 1);
  for (unsigned seed = 1; seed <= 5; ++seed)
    expect_near(tightness_of(meshes::shuffled(model, seed), meshes::shuffled(cage, seed)), plain, 1, 1e-12);
}

TEST(Tightness, DoesNotDependOnWhichCornerOfATriangleIsTheFirst) {
  const IndexedMesh model = meshes::icosphere(2),
                    cage = shaken(meshes::moved(meshes::icosphere(0), 2, {0, 0, 0}), 8, 0.5);
  IndexedMesh turned = cage;
  for (int i = 0; i < 3; ++i) turned.triangles.col(i) = cage.triangles.col((i + 1) % 3);
  expect_near(tightness_of(model, turned), tightness_of(model, cage), 1, 1e-12);
}

TEST(Tightness, IsTheSameBitsForAnyNumberOfThreads) {
  const IndexedMesh model = shaken(meshes::icosphere(5), 7, 0.01),
                    cage = meshes::moved(meshes::icosphere(1), 1.5, {0, 0, 0});
  const Tightness one = tightness_of(model, cage, 1);
  for (const unsigned threads : {2u, 3u, 8u}) {
    const Tightness several = tightness_of(model, cage, threads);
    EXPECT_EQ(one.volume_ratio, several.volume_ratio);
    EXPECT_EQ(one.mean_gap, several.mean_gap);
    EXPECT_EQ(one.max_gap, several.max_gap);
    EXPECT_EQ(one.clearance, several.clearance);
    EXPECT_EQ(one.coverage, several.coverage);
  }
}

TEST(Tightness, FindsTheLeastDistanceThatAllPairsHave) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const IndexedMesh model = shaken(meshes::icosphere(2), seed, 0.1);
    Random random(seed);
    const IndexedMesh cage =
        shaken(meshes::moved(meshes::icosphere(seed % 3), random.uniform(1.5, 3), 0.1 * random.direction()), seed, 0.1);
    if (!certify(model, cage).model_cage_intersections.empty()) continue;
    const double diagonal = diagonal_of(model);
    double least = std::numeric_limits<double>::infinity();
    for (Eigen::Index s = 0; s < cage.triangles.rows(); ++s)
      for (Eigen::Index t = 0; t < model.triangles.rows(); ++t)
        least = std::min(least, triangle_distance(corners(model, t), corners(cage, s)));
    EXPECT_NEAR(tightness_of(model, cage).clearance * diagonal, least, 1e-12);
    EXPECT_NEAR(tightness_of(model, meshes::inside_out(cage)).clearance * diagonal, least, 1e-12);
  }
}

TEST(Tightness, HasNoClearanceWhereCageAndModelMeet) {
  EXPECT_EQ(tightness_of(cube(1), cube(1)).clearance, 0);
  EXPECT_EQ(tightness_of(cube(1), meshes::box({-1, -2, -2}, {2, 2, 2})).clearance, 0) << "they touch in a face";
  EXPECT_EQ(tightness_of(meshes::icosphere(3), cube(0.7)).clearance, 0);
  EXPECT_GT(tightness_of(cube(1), meshes::box({2, 2, 2}, {3, 3, 3})).clearance, 0) << "side by side";
}

TEST(Tightness, CountsTheAreaRoundTheVerticesThatAreInside) {
  const IndexedMesh model = meshes::icosphere(3);
  for (const double wall : {-0.5, 0.013, 0.7}) {
    double inside = 0, all = 0;
    for (Eigen::Index t = 0; t < model.triangles.rows(); ++t) {
      const Triangle3 c = corners(model, t);
      const double area = area_of(c);
      all += area;
      for (const Vector3& corner : c) inside += corner.x() < wall ? area / 3 : 0;
    }
    const Tightness tightness = tightness_of(model, meshes::box({-2, -2, -2}, {wall, 2, 2}));
    EXPECT_NEAR(tightness.coverage.value(), inside / all, 1e-12);
  }
  EXPECT_NEAR(tightness_of(model, meshes::box({2, 2, 2}, {3, 3, 3})).coverage.value(), 0, 1e-12);
}

TEST(Tightness, HasNeitherVolumeNorCoverageWhereTheCageIsOpenOrTurned) {
  const IndexedMesh open = meshes::without_triangle(cube(2), 3), turned = meshes::randomly_turned(cube(2), 1);
  for (const IndexedMesh& cage : {open, turned}) {
    const Tightness tightness = tightness_of(cube(1), cage);
    EXPECT_FALSE(tightness.volume_ratio);
    EXPECT_FALSE(tightness.coverage);
    EXPECT_NEAR(tightness.clearance * 2 * std::sqrt(3), 1, 1e-12);
    EXPECT_GT(tightness.mean_gap, 0);
  }
}

TEST(Tightness, SaysThatACageFacesInward) {
  const Tightness tightness = tightness_of(cube(1), meshes::inside_out(cube(2)));
  EXPECT_NEAR(tightness.volume_ratio.value(), -8, 1e-12);
  EXPECT_EQ(tightness.coverage.value(), 0);
  EXPECT_NEAR(tightness_of(meshes::inside_out(cube(1)), cube(2)).volume_ratio.value(), 8, 1e-12) << "the model does";
}

TEST(Tightness, DoesNotMindSplitVertices) {
  const IndexedMesh model = meshes::icosphere(3),
                    cage = shaken(meshes::moved(meshes::icosphere(1), 1.1, {0, 0, 0}), 2, 0.1);
  expect_near(tightness_of(model, meshes::with_own_vertices(cage)), tightness_of(model, cage), 1, 1e-12);
}

TEST(Tightness, HoldsForCagesOfManyTriangles) {
  for (const int subdivisions : {4, 5}) {  // 5,120 and 20,480: 8 rows, 3 rows
    const IndexedMesh model = meshes::icosphere(subdivisions);
    const Tightness tightness = tightness_of(model, meshes::moved(model, 1.1, Vector3::Zero()));
    EXPECT_NEAR(tightness.mean_gap * diagonal_of(model), 0.1, 0.001);
    EXPECT_EQ(tightness.coverage.value(), 1);
  }
}

TEST(Tightness, RefusesACageThatIsNone) {
  const IndexedMesh model = meshes::icosphere(1);
  IndexedMesh cage = cube(2);
  cage.points(3, 1) = std::numeric_limits<double>::quiet_NaN();
  const Certificate certificate;
  expect_error([&] { measure_tightness(MeasuredModel(model), cage, certificate); }, ErrorCode::mesh_not_finite,
               {"vertex 3"});
  expect_error([&] { measure_tightness(MeasuredModel(model), {}, certificate); }, ErrorCode::mesh_empty, {});
}

TEST(MeasuredModel, KnowsTheMomentsOfABoxesSurface) {
  const Vector3 half(1, 2, 3), center(4, -5, 6);
  const MeasuredModel model(meshes::box(center - half, center + half));
  EXPECT_LT((model.to_model(model.centroid()) - center).norm(), 1e-12);
  const double diagonal = 2 * half.norm(), sides = half[0] * half[1] + half[1] * half[2] + half[2] * half[0];
  for (int axis = 0; axis < 3; ++axis) {
    const double ends = half[(axis + 1) % 3] * half[(axis + 2) % 3];
    const double moment = half[axis] * half[axis] * (ends + (sides - ends) / 3) / sides;
    EXPECT_NEAR(model.covariance()(axis, axis) * diagonal * diagonal, moment, 1e-12);
    EXPECT_NEAR(model.covariance()(axis, (axis + 1) % 3), 0, 1e-14);
  }
  double sum = 0;
  for (int v = 0; v < 8; ++v) sum += model.vertex_share(v);
  EXPECT_NEAR(sum, 1, 1e-14);
}

TEST(SurfaceTree, FindsTheNearestTriangleFromAnyHint) {
  Random random(11);
  const IndexedMesh mesh = shaken(meshes::icosphere(2), 12, 0.3);
  const SurfaceTree tree(mesh);
  for (int trial = 0; trial < 300; ++trial) {
    const Vector3 point = random.uniform(0, 3) * random.direction();
    double least = std::numeric_limits<double>::infinity();
    for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t)
      least = std::min(least, triangle_distance({point, point, point}, corners(mesh, t)));
    const SurfaceTree::Nearest found = tree.nearest(point, random.below(static_cast<int>(mesh.triangles.rows())));
    EXPECT_NEAR(found.distance, least, 1e-14);
    EXPECT_EQ(tree.nearest(point, found.place).distance, found.distance);
  }
}

TEST(SurfaceTree, HoldsForOneTriangleAndForTrianglesWithoutArea) {
  IndexedMesh mesh{Points(3, 3), Triangles(1, 3)};
  mesh.points << 0, 0, 0, 1, 0, 0, 0, 1, 0;
  mesh.triangles << 0, 1, 2;
  EXPECT_EQ(SurfaceTree(mesh).nearest({0.25, 0.25, 2}).distance, 2);
  mesh.points.row(2) << 3, 0, 0;  // on a line, the last corner at its end
  EXPECT_EQ(SurfaceTree(mesh).nearest({2, 1, 0}).distance, 1);
  mesh.points.row(1) = mesh.points.row(2) = mesh.points.row(0);
  EXPECT_EQ(SurfaceTree(mesh).nearest({0, 3, 4}).distance, 5);
}

TEST(SurfaceSamples, WeighTrianglesByAreaAndStayInside) {
  const IndexedMesh mesh = shaken(meshes::icosphere(1), 13, 0.4);
  for (const std::size_t most : {7u, 80u, 240u, 100000u}) {
    const SurfaceSamples samples(mesh, most);
    EXPECT_LE(samples.triangles() * samples.points_each(), most);
    EXPECT_GE(samples.triangles() * samples.points_each(), std::min<std::size_t>(most / 2, 80 * 78));
    double sum = 0;
    for (std::size_t t = 0; t < samples.triangles(); ++t) {
      const Triangle3 c = corners(mesh, samples.row(t));
      Vector3 mean = Vector3::Zero();
      for (std::size_t k = 0; k < samples.points_each(); ++k) {
        EXPECT_LT(triangle_distance({samples.point(t, k), samples.point(t, k), samples.point(t, k)}, c), 1e-14);
        mean += samples.point(t, k) / static_cast<double>(samples.points_each());
      }
      EXPECT_LT((mean - (c[0] + c[1] + c[2]) / 3).norm(), 1e-14);
      EXPECT_NEAR(samples.share(t) / samples.share(0), area_of(c) / area_of(corners(mesh, 0)), 1e-12);
      sum += samples.share(t);
    }
    EXPECT_NEAR(sum, 1, 1e-14);
  }
}

}  // namespace
}  // namespace cagewright
