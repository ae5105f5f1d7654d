// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "core/error/error.h"
#include "core/mesh/inspect.h"
#include "core/tests/expect_error.h"
#include "core/tests/meshes.h"

namespace cagewright {
namespace {

void expect_sound(const IndexedMesh& mesh, long genus) {
  const MeshReport report = inspect(mesh);
  EXPECT_TRUE(report.closed());
  EXPECT_TRUE(report.consistently_oriented());
  EXPECT_FALSE(report.inside_out);
  EXPECT_EQ(report.bow_tie_vertices, 0u);
  EXPECT_EQ(report.genus, genus);
  EXPECT_FALSE(report.first_open_edge || report.first_non_manifold_edge || report.first_inconsistent_edge ||
               report.first_bow_tie);
}

TEST(Inspect, FindsNothingWrongWithSoundMeshes) {
  expect_sound(meshes::tetrahedron(), 0);
  expect_sound(meshes::capsule(0.5, 2, 12, 4), 0);
  expect_sound(meshes::torus(3, 1, 16, 8), 1);
  expect_sound(meshes::perforated_plate(3), 3);
  expect_sound(meshes::shuffled(meshes::perforated_plate(3), 3), 3);
  expect_sound(meshes::with_own_vertices(meshes::torus(3, 1, 16, 8)), 1);
}

TEST(Inspect, GenusAddsUpOverComponents) {
  const IndexedMesh both =
      meshes::together(meshes::torus(3, 1, 16, 8), meshes::moved(meshes::perforated_plate(2), 1, {10, 0, 0}));
  const MeshReport report = inspect(both);
  EXPECT_EQ(report.components, 2u);
  EXPECT_EQ(report.genus, 3);
}

TEST(Inspect, CountsOpenEdgesAndTellsTheFirst) {
  const MeshReport report = inspect(meshes::without_triangle(meshes::tetrahedron(), 3));
  EXPECT_EQ(report.open_edges, 3u);
  EXPECT_FALSE(report.closed());
  EXPECT_FALSE(report.genus);
  ASSERT_TRUE(report.first_open_edge);
  EXPECT_EQ(*report.first_open_edge, Vector3(0.5, 0.5, 0));  // of triangle 0, from corner 2 to corner 1
}

TEST(Inspect, CountsNonManifoldEdgesAndTellsTheFirst) {
  const MeshReport report = inspect(meshes::bow_tie_edge());
  EXPECT_EQ(report.non_manifold_edges, 1u);
  EXPECT_EQ(report.open_edges, 0u);
  EXPECT_FALSE(report.closed());
  ASSERT_TRUE(report.first_non_manifold_edge);
  EXPECT_EQ(*report.first_non_manifold_edge, Vector3(1, 1, 0.5));
}

TEST(Inspect, KeepsEdgesApartThatOnlyTheWeldBroughtTogether) {
  const MeshReport report = inspect(meshes::touching_boxes());
  EXPECT_TRUE(report.closed());
  EXPECT_EQ(report.components, 2u);
  EXPECT_EQ(report.bow_tie_vertices, 2u);
  EXPECT_EQ(report.genus, 0);
}

TEST(Inspect, CountsTrianglesThatCoincideAsNonManifold) {
  const MeshReport doubled = inspect(meshes::together(meshes::tetrahedron(), meshes::tetrahedron()));
  EXPECT_EQ(doubled.non_manifold_edges, 6u);
  const IndexedMesh box = meshes::box({0, 0, 0}, {1, 1, 1});
  IndexedMesh mirrored = meshes::inside_out(box);
  mirrored.points.col(0) *= -1;
  const MeshReport walled = inspect(meshes::together(box, mirrored));
  EXPECT_EQ(walled.non_manifold_edges, 5u);
  EXPECT_FALSE(walled.closed());
}

TEST(Inspect, CountsInconsistentEdgesAndTellsTheFirst) {
  IndexedMesh mesh = meshes::tetrahedron();
  mesh.triangles.row(3) << 2, 1, 3;
  const MeshReport report = inspect(mesh);
  EXPECT_EQ(report.inconsistent_edges, 3u);
  EXPECT_TRUE(report.closed());
  EXPECT_FALSE(report.consistently_oriented());
  EXPECT_FALSE(report.inside_out);
  EXPECT_EQ(report.genus, 0);
  ASSERT_TRUE(report.first_inconsistent_edge);
  EXPECT_EQ(*report.first_inconsistent_edge, Vector3(0.5, 0.5, 0));
}

TEST(Inspect, CallsNothingInsideOutThatIsInconsistent) {
  IndexedMesh mesh = meshes::inside_out(meshes::icosphere(1));
  std::swap(mesh.triangles(7, 0), mesh.triangles(7, 1));
  const MeshReport report = inspect(mesh);
  EXPECT_LT(report.signed_volume, 0);
  EXPECT_FALSE(report.inside_out);
}

TEST(Inspect, CountsBowTiesAndSplitsThemForTheGenus) {
  const MeshReport two = inspect(meshes::bow_tie());
  EXPECT_EQ(two.bow_tie_vertices, 1u);
  EXPECT_EQ(two.first_bow_tie, Vector3(0, 0, 0));
  EXPECT_EQ(two.components, 2u);
  EXPECT_EQ(two.genus, 0);
  const MeshReport ring = inspect(meshes::pinched_ring());
  EXPECT_EQ(ring.bow_tie_vertices, 1u);
  EXPECT_EQ(ring.first_bow_tie, Vector3(1, 1, 1));
  EXPECT_EQ(ring.components, 1u);
  EXPECT_EQ(ring.genus, 0);
}

TEST(Inspect, CountsABowTieWhoseFansAreTurnedAtRandom) {
  EXPECT_EQ(inspect(meshes::randomly_turned(meshes::pinched_ring(), 5)).bow_tie_vertices, 1u);
  EXPECT_EQ(inspect(meshes::randomly_turned(meshes::torus(3, 1, 16, 8), 5)).bow_tie_vertices, 0u);
}

TEST(Inspect, TellsInsideOutByTheWholeVolume) {
  EXPECT_TRUE(inspect(meshes::inside_out(meshes::icosphere(2))).inside_out);
  EXPECT_TRUE(inspect(meshes::inside_out(meshes::hollow_sphere(2))).inside_out);
  EXPECT_FALSE(inspect(meshes::hollow_sphere(2)).inside_out);
}

TEST(Inspect, GivesNoGenusToOneSidedSurfaces) {
  const MeshReport report = inspect(meshes::klein_bottle(12, 9));
  EXPECT_TRUE(report.closed());
  EXPECT_FALSE(report.genus);
}

TEST(Inspect, MeasuresVolumeAndBoxFarFromTheOrigin) {
  const Vector3 far(1e9, -1e9, 1e9);  // powers of two apart, the corners stay exact
  const MeshReport report = inspect(meshes::box(far, far + Vector3(1, 2, 4)));
  EXPECT_DOUBLE_EQ(report.signed_volume, 8);
  EXPECT_EQ(report.box_min, far);
  EXPECT_DOUBLE_EQ(report.diagonal(), std::sqrt(21));
}

TEST(Inspect, TellsInsideOutAtAnyMagnitude) {
  for (const double scale : {1e-300, 1e-150, 1e-30, 1e30, 1e150, 1e300}) {
    const MeshReport report = inspect(meshes::moved(meshes::inside_out(meshes::icosphere(2)), scale, Vector3::Zero()));
    EXPECT_TRUE(report.inside_out) << scale;
    EXPECT_EQ(report.genus, 0) << scale;
    EXPECT_NEAR(report.diagonal() / scale, 2 * std::sqrt(3), 0.1) << scale;
  }
}

TEST(Inspect, IgnoresWhatNoTriangleUses) {
  IndexedMesh mesh = meshes::tetrahedron();
  mesh.points.conservativeResize(5, 3);
  mesh.points.row(4) << 100, 100, 100;
  const MeshReport report = inspect(mesh);
  EXPECT_EQ(report.vertices, 4u);
  EXPECT_EQ(report.unused_vertices, 1u);
  EXPECT_EQ(report.box_max, Vector3(1, 1, 1));
}

TEST(Inspect, RefusesWhatIsNoMesh) {
  expect_error([] { inspect(IndexedMesh()); }, ErrorCode::mesh_empty, {"no triangle"});
}

}  // namespace
}  // namespace cagewright
