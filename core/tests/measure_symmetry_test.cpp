// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "core/measure/symmetry.h"
#include "core/mesh/tolerance.h"
#include "core/tests/meshes.h"
#include "core/tests/shapes.h"

namespace cagewright {
namespace {

IndexedMesh sheared(IndexedMesh mesh, double x_by_y, double x_by_z, double y_by_z) {
  Eigen::Matrix3d shear = Eigen::Matrix3d::Identity();
  shear(0, 1) = x_by_y;
  shear(0, 2) = x_by_z;
  shear(1, 2) = y_by_z;
  mesh.points = mesh.points * shear.transpose();
  return mesh;
}

const IndexedMesh brick = meshes::box({-3, -2, -1}, {3, 2, 1});

std::vector<MirrorPlane> planes_of(const IndexedMesh& mesh) { return find_mirror_planes(MeasuredModel(mesh)); }
std::optional<Asymmetry> asymmetry_of(const IndexedMesh& model, const IndexedMesh& cage) {
  const MeasuredModel measured(model);
  return measure_asymmetry(measured, find_mirror_planes(measured), cage);
}

TEST(Symmetry, FindsTheThreePlanesOfABrickWhereverItIs) {
  const auto expect_planes = [](const shapes::Motion& motion) {
    const std::vector<MirrorPlane> planes = planes_of(shapes::moved(brick, motion));
    ASSERT_EQ(planes.size(), 3u);
    for (int axis = 0; axis < 3; ++axis) {
      int found = 0;
      for (const MirrorPlane& plane : planes) {
        const Vector3 normal = motion.rotation.col(axis);
        if (std::abs(plane.normal.dot(normal)) < 0.5) continue;
        ++found;
        EXPECT_NEAR(std::abs(plane.normal.dot(normal)), 1, 1e-12);
        EXPECT_NEAR(plane.normal.dot(plane.point - motion.offset), 0, 1e-12 * (motion.scale + motion.offset.norm()));
        EXPECT_LT(plane.deviation, 1e-12);
      }
      EXPECT_EQ(found, 1);
    }
  };
  expect_planes({});
  for (unsigned seed = 1; seed <= 10; ++seed) expect_planes(shapes::random_motion(seed, seed % 2 ? 1e-4 : 50, 10));
}

TEST(Symmetry, FindsNoPlaneInASkewedBrick) {
  EXPECT_TRUE(planes_of(sheared(brick, 0.3, 0.2, 0.4)).empty());
  EXPECT_FALSE(asymmetry_of(sheared(brick, 0.3, 0.2, 0.4), brick));
}

TEST(Symmetry, FindsTheOnePlaneThatASkewLeaves) {
  const std::vector<MirrorPlane> planes = planes_of(sheared(brick, 0.5, 0, 0));
  ASSERT_EQ(planes.size(), 1u);
  EXPECT_EQ(planes[0].normal, Vector3::UnitZ());
}

TEST(Symmetry, AllowsAsMuchAsItsToleranceOnAverage) {
  const auto plate = [](double bump) {  // one side stands out by `bump` more than the other
    IndexedMesh mesh = meshes::icosphere(4);
    for (Eigen::Index v = 0; v < mesh.points.rows(); ++v) {
      Vector3 point = mesh.points.row(v);
      point = point.cwiseProduct(Vector3(1, 0.7, 0.4));
      if (point.x() > 0) point.x() += bump * point.x() * point.x();
      point.y() += 0.3 * point.x() * point.x();
      point.z() += 0.2 * point.x() * point.x();
      mesh.points.row(v) = point.transpose();
    }
    return mesh;
  };
  ASSERT_EQ(planes_of(plate(0)).size(), 1u);
  EXPECT_EQ(planes_of(plate(0))[0].normal, Vector3::UnitX());
  ASSERT_EQ(planes_of(plate(0.002)).size(), 1u);
  EXPECT_GT(planes_of(plate(0.002))[0].deviation, 1e-5);
  EXPECT_LT(planes_of(plate(0.002))[0].deviation, tolerance::mirror);
  EXPECT_TRUE(planes_of(plate(0.05)).empty());
}

TEST(Symmetry, LooksAtTheSurfaceAndNotAtItsTriangles) {
  IndexedMesh ellipsoid = meshes::icosphere(5);
  ellipsoid.points = ellipsoid.points * Vector3(3, 2, 1).asDiagonal();
  EXPECT_EQ(planes_of(shapes::moved(ellipsoid, shapes::random_motion(1, 1, 1))).size(), 3u);
  EXPECT_EQ(planes_of(meshes::shuffled(meshes::with_own_vertices(brick), 3)).size(), 3u);
}

TEST(Symmetry, TriesNoAxisThatIsOneOfMany) {
  EXPECT_EQ(planes_of(meshes::icosphere(4)).size(), 3u) << "the coordinate planes";
  const IndexedMesh tube = meshes::capsule(1, 3, 32, 8);
  EXPECT_EQ(planes_of(tube).size(), 3u);
  const shapes::Motion motion = shapes::random_motion(2, 1, 1);
  const std::vector<MirrorPlane> planes = planes_of(shapes::moved(tube, motion));
  ASSERT_EQ(planes.size(), 1u);
  EXPECT_NEAR(std::abs(planes[0].normal.dot(motion.rotation.col(2))), 1, 1e-9);
}

TEST(Symmetry, FindsNoneInBodiesWithout) {
  EXPECT_TRUE(planes_of(shapes::fork(1).mesh).empty());
  EXPECT_TRUE(planes_of(shapes::handle_body().mesh).empty());
}

TEST(Asymmetry, IsNoneForACageAsSymmetricAsItsModel) {
  const Asymmetry asymmetry = asymmetry_of(brick, meshes::box({-4, -3, -2}, {4, 3, 2})).value();
  EXPECT_LT(asymmetry.mean, 1e-15);
  EXPECT_LT(asymmetry.max, 1e-15);
}

TEST(Asymmetry, IsTwiceTheShiftWhereTheCageIsShifted) {
  const double diagonal = brick.points.row(0).norm() * 2;
  for (const double shift : {0.001, 0.01, -0.01}) {
    const Asymmetry asymmetry = asymmetry_of(brick, meshes::box({-4 + shift, -3, -2}, {4 + shift, 3, 2})).value();
    EXPECT_NEAR(asymmetry.max * diagonal, 2 * std::abs(shift), 1e-12);
    // The two ends, of 24 in an area of 208, are 2 shift away; the sides fall into themselves but for a strip.
    EXPECT_NEAR(asymmetry.mean * diagonal, 2 * std::abs(shift) * 48 / 208, 1e-3 * std::abs(shift));
  }
}

TEST(Asymmetry, TakesTheWorstOfThePlanes) {
  const double diagonal = brick.points.row(0).norm() * 2;
  for (int axis = 0; axis < 3; ++axis) {
    IndexedMesh cage = meshes::box({-4, -3, -2}, {4, 3, 2});
    cage.points.col(axis).array() += 0.1;
    EXPECT_NEAR(asymmetry_of(brick, cage).value().max * diagonal, 0.2, 1e-12);
  }
}

TEST(Asymmetry, StaysUnderMotionsAndIsTheSameBitsForAnyNumberOfThreads) {
  IndexedMesh cage = meshes::box({-4, -3, -2}, {4, 3, 2});
  cage.points.row(2) += Eigen::RowVector3d(0.3, 0.2, 0.4);
  const Asymmetry here = asymmetry_of(brick, cage).value();
  EXPECT_GT(here.mean, 1e-3);
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const shapes::Motion motion = shapes::random_motion(seed, 3, 10);
    const IndexedMesh model = shapes::moved(brick, motion), moved = shapes::moved(cage, motion);
    const MeasuredModel measured(model);
    const double scale = (model.points.colwise().maxCoeff() - model.points.colwise().minCoeff()).norm() / 3 /
                         (brick.points.row(0).norm() * 2);
    const Asymmetry one = measure_asymmetry(measured, find_mirror_planes(measured, 1), moved, 1).value();
    EXPECT_NEAR(one.mean * scale, here.mean, 1e-10);
    EXPECT_NEAR(one.max * scale, here.max, 1e-10);
    const Asymmetry three = measure_asymmetry(measured, find_mirror_planes(measured, 3), moved, 3).value();
    EXPECT_EQ(one.mean, three.mean);
    EXPECT_EQ(one.max, three.max);
  }
}

}  // namespace
}  // namespace cagewright
