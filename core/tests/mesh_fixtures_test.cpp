// SPDX-License-Identifier: BSD-3-Clause
// The fixtures are what they say: judged here by plain counting that shares no code with core/mesh.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <map>
#include <numbers>
#include <set>
#include <utility>

#include "core/tests/meshes.h"

namespace cagewright {
namespace {

struct Counts {
  long characteristic = 0;
  int open = 0, shared = 0, same_direction = 0;  // edges
  double volume = 0;
};

Counts count(const IndexedMesh& mesh) {
  std::map<std::pair<int, int>, std::pair<int, int>> uses;  // forward, backward
  std::set<int> used;
  Counts counts;
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    const Eigen::RowVector3i corner = mesh.triangles.row(t);
    for (int i = 0; i < 3; ++i) {
      const int from = corner[i], to = corner[(i + 1) % 3];
      used.insert(from);
      auto& [forward, backward] = uses[std::minmax(from, to)];
      ++(from < to ? forward : backward);
    }
    const Vector3 a = mesh.points.row(corner[0]), b = mesh.points.row(corner[1]), c = mesh.points.row(corner[2]);
    counts.volume += a.dot(b.cross(c)) / 6;
  }
  for (const auto& [edge, directions] : uses) {
    const auto [forward, backward] = directions;
    counts.open += forward + backward == 1;
    counts.shared += forward + backward > 2;
    counts.same_direction += forward + backward == 2 && forward != backward;
  }
  counts.characteristic = static_cast<long>(used.size()) - static_cast<long>(uses.size()) + mesh.triangles.rows();
  return counts;
}

void expect_closed(const IndexedMesh& mesh, long characteristic) {
  const Counts counts = count(mesh);
  EXPECT_EQ(counts.open, 0);
  EXPECT_EQ(counts.shared, 0);
  EXPECT_EQ(counts.same_direction, 0);
  EXPECT_EQ(counts.characteristic, characteristic);
  EXPECT_GT(counts.volume, 0);
}

TEST(MeshFixtures, GenusZeroIsClosedAndFacesOutward) {
  expect_closed(meshes::tetrahedron(), 2);
  expect_closed(meshes::box({-1, 2, 0}, {3, 5, 1}), 2);
  expect_closed(meshes::icosphere(0), 2);
  expect_closed(meshes::icosphere(3), 2);
  expect_closed(meshes::capsule(0.5, 2, 12, 4), 2);
}

TEST(MeshFixtures, HigherGenusIsClosedAndFacesOutward) {
  expect_closed(meshes::torus(3, 1, 16, 8), 0);
  expect_closed(meshes::perforated_plate(1), 0);
  expect_closed(meshes::perforated_plate(3), -4);
}

TEST(MeshFixtures, VolumesAreThoseOfTheSolids) {
  EXPECT_DOUBLE_EQ(count(meshes::tetrahedron()).volume, 1.0 / 6);
  EXPECT_DOUBLE_EQ(count(meshes::box({-1, 2, 0}, {3, 5, 1})).volume, 12);
  EXPECT_DOUBLE_EQ(count(meshes::perforated_plate(3)).volume, 18);
  EXPECT_NEAR(count(meshes::icosphere(4)).volume, 4 * std::numbers::pi / 3, 0.02);
  EXPECT_NEAR(count(meshes::capsule(1, 2, 64, 16)).volume, 4 * std::numbers::pi / 3 + 2 * std::numbers::pi, 0.05);
  EXPECT_NEAR(count(meshes::torus(3, 1, 96, 48)).volume, 6 * std::numbers::pi * std::numbers::pi, 0.5);
}

TEST(MeshFixtures, BowTiesAreClosedWithOneVertexTooFew) {
  expect_closed(meshes::bow_tie(), 3);       // two spheres have 4
  expect_closed(meshes::pinched_ring(), 1);  // a sphere has 2
}

TEST(MeshFixtures, BoxesThatTouchShareAnEdgeOnlyWhereTheyShareVertices) {
  EXPECT_EQ(count(meshes::bow_tie_edge()).shared, 1);
  EXPECT_EQ(count(meshes::bow_tie_edge()).open, 0);
  expect_closed(meshes::touching_boxes(), 4);
}

TEST(MeshFixtures, OneSidedSurfacesHaveNoConsistentOrientation) {
  const Counts bottle = count(meshes::klein_bottle(12, 9)), band = count(meshes::moebius_band(12));
  EXPECT_EQ(bottle.open + bottle.shared, 0);
  EXPECT_EQ(bottle.characteristic, 0);
  EXPECT_GT(bottle.same_direction, 0);
  EXPECT_GT(band.open, 0);
  EXPECT_EQ(band.characteristic, 0);
  EXPECT_GT(band.same_direction, 0);
}

TEST(MeshFixtures, ShufflingKeepsTheSolid) {
  const IndexedMesh torus = meshes::torus(3, 1, 16, 8), shuffled = meshes::shuffled(torus, 7);
  expect_closed(shuffled, 0);
  EXPECT_NEAR(count(shuffled).volume, count(torus).volume, 1e-12);
  EXPECT_NE(shuffled.triangles, torus.triangles);
}

}  // namespace
}  // namespace cagewright
