// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>
#include <vector>

#include "core/error/error.h"
#include "core/mesh/prepare.h"
#include "core/tests/expect_error.h"
#include "core/tests/meshes.h"

namespace cagewright {
namespace {

// What every stage relies on, judged by OpenMesh's own walk and by the volume against the origin.
void expect_model(const Model& model) {
  for (const auto v : model.mesh.vertices()) {
    EXPECT_TRUE(model.mesh.is_manifold(v));
    EXPECT_FALSE(model.mesh.is_boundary(v));
  }
  double volume = 0;
  const auto [points, triangles] = to_indexed_mesh(model.mesh);
  for (Eigen::Index t = 0; t < triangles.rows(); ++t) {
    const Vector3 a = points.row(triangles(t, 0)), b = points.row(triangles(t, 1)), c = points.row(triangles(t, 2));
    volume += a.dot(b.cross(c)) / 6;
  }
  EXPECT_GT(model.volume, 0);
  EXPECT_NEAR(model.volume, volume, 1e-9 * volume);
}

std::size_t triangles_of(const IndexedMesh& mesh) { return static_cast<std::size_t>(mesh.triangles.rows()); }

TEST(PrepareModel, LeavesASoundModelAsItIs) {
  const IndexedMesh torus = meshes::torus(3, 1, 16, 8);
  const Model model = prepare_model(torus);
  const IndexedMesh prepared = to_indexed_mesh(model.mesh);
  expect_model(model);
  EXPECT_EQ(prepared.points, torus.points);
  EXPECT_EQ(prepared.triangles, torus.triangles);
  EXPECT_EQ(model.report.turned_triangles, 0u);
  EXPECT_DOUBLE_EQ(model.diagonal, std::sqrt(8 * 8 + 8 * 8 + 2 * 2));
}

TEST(PrepareModel, WeldsWhatFilesSplit) {
  const Model model = prepare_model(meshes::with_own_vertices(meshes::perforated_plate(3)));
  expect_model(model);
  EXPECT_EQ(model.report.genus, 3);
  EXPECT_DOUBLE_EQ(model.volume, 18);
}

TEST(PrepareModel, SplitsBowTiesIntoAVertexForEachFan) {
  for (const IndexedMesh& mesh : {meshes::bow_tie(), meshes::pinched_ring()}) {
    const Model model = prepare_model(mesh);
    expect_model(model);
    EXPECT_EQ(static_cast<Eigen::Index>(model.mesh.n_vertices()), mesh.points.rows() + 1);
    EXPECT_EQ(model.report.bow_tie_vertices, 1u);
  }
}

TEST(PrepareModel, SplitsBowTiesOfTurnedModels) {
  const Model model = prepare_model(meshes::randomly_turned(meshes::pinched_ring(), 11));
  expect_model(model);
  EXPECT_DOUBLE_EQ(model.volume, 10);
}

TEST(PrepareModel, TakesSolidsApartThatTouchAlongAnEdge) {
  const Model model = prepare_model(meshes::touching_boxes());
  expect_model(model);
  EXPECT_EQ(model.mesh.n_vertices(), 16u);
  EXPECT_DOUBLE_EQ(model.volume, 2);
}

TEST(PrepareModel, TurnsWhatIsInsideOutAndSaysSo) {
  const IndexedMesh mesh = meshes::inside_out(meshes::icosphere(2));
  const Model model = prepare_model(mesh);
  expect_model(model);
  EXPECT_TRUE(model.report.inside_out);
  EXPECT_EQ(model.report.turned_triangles, triangles_of(mesh));
}

TEST(PrepareModel, TurnsTheFewerOfInconsistentTriangles) {
  IndexedMesh mesh = meshes::icosphere(2);
  for (const Eigen::Index t : {0, 5, 77}) std::swap(mesh.triangles(t, 1), mesh.triangles(t, 2));
  const Model model = prepare_model(mesh);
  expect_model(model);
  EXPECT_EQ(model.report.turned_triangles, 3u);
}

TEST(PrepareModel, OrientsTrianglesThatAreTurnedAtRandom) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const IndexedMesh mesh = meshes::randomly_turned(meshes::torus(3, 1, 12, 7), seed);
    const Model model = prepare_model(mesh);
    expect_model(model);
    const IndexedMesh prepared = to_indexed_mesh(model.mesh);
    std::size_t turned = 0;
    for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t)
      turned += prepared.triangles.row(t) != mesh.triangles.row(t);
    EXPECT_EQ(model.report.turned_triangles, turned);
    EXPECT_NEAR(model.volume, prepare_model(meshes::torus(3, 1, 12, 7)).volume, 1e-9);
  }
}

TEST(PrepareModel, KeepsACavity) {
  const Model model = prepare_model(meshes::hollow_sphere(3));
  expect_model(model);
  EXPECT_EQ(model.report.turned_triangles, 0u);
  EXPECT_NEAR(model.volume, 7.0 / 8 * prepare_model(meshes::icosphere(3)).volume, 1e-9);
}

TEST(PrepareModel, TurnsAModelWithItsCavity) {
  const IndexedMesh mesh = meshes::inside_out(meshes::hollow_sphere(3));
  const Model model = prepare_model(mesh);
  expect_model(model);
  EXPECT_EQ(model.report.turned_triangles, triangles_of(mesh));
  EXPECT_NEAR(model.volume, 7.0 / 8 * prepare_model(meshes::icosphere(3)).volume, 1e-9);
}

TEST(PrepareModel, TurnsOnlyTheComponentThatIsInsideOut) {
  const IndexedMesh ball = meshes::icosphere(2);
  const IndexedMesh turned = meshes::moved(meshes::inside_out(ball), 2, {10, 0, 0});  // the larger of the two
  const Model model = prepare_model(meshes::together(ball, turned));
  expect_model(model);
  EXPECT_EQ(model.report.turned_triangles, triangles_of(turned));
  EXPECT_NEAR(model.volume, 9 * prepare_model(ball).volume, 1e-9);
}

TEST(PrepareModel, TurnsAComponentBesideAnotherThoughItsBoxIsInside) {
  // The hole of the torus is inside its box, not inside it.
  const IndexedMesh ball = meshes::inside_out(meshes::icosphere(2));
  const Model model = prepare_model(meshes::together(meshes::torus(5, 2, 32, 16), ball));
  expect_model(model);
  EXPECT_EQ(model.report.turned_triangles, triangles_of(ball));
}

TEST(PrepareModel, TurnsAComponentInAnyHoleOfAnother) {
  const IndexedMesh ball = meshes::inside_out(meshes::icosphere(1));
  IndexedMesh torus = meshes::torus(5, 2, 32, 16);
  for (int axis = 0; axis < 3; ++axis) {
    const Points before = torus.points;
    torus.points << before.col(1), before.col(2), before.col(0);
    EXPECT_EQ(prepare_model(meshes::together(ball, torus)).report.turned_triangles, triangles_of(ball)) << axis;
  }
}

TEST(PrepareModel, TurnsAComponentBeyondASlantedFace) {
  const IndexedMesh ball = meshes::moved(meshes::inside_out(meshes::icosphere(1)), 0.5, {4, 4, 4});
  const IndexedMesh slanted = meshes::moved(meshes::tetrahedron(), 10, Vector3::Zero());
  EXPECT_EQ(prepare_model(meshes::together(slanted, ball)).report.turned_triangles, triangles_of(ball));
}

TEST(PrepareModel, TurnsAComponentExactlyBelowAnEdge) {
  // A sliver in the hole of an upright ring, its extreme vertices below a diagonal of the ring's top or of its ceiling.
  IndexedMesh ring = meshes::perforated_plate(1);
  const Points before = ring.points;
  ring.points << before.col(1), before.col(2), before.col(0);
  for (const bool rising : {true, false}) {
    IndexedMesh sliver = meshes::tetrahedron();
    sliver.points << 1.25, 0.25, 1.25, 1.75, 0.75, 1.25, 1.5, 0.5, 1.75, 1.625, 0.5, 1.5;
    if (!rising) sliver.points.col(1) = 1 - sliver.points.col(1).array();
    if (inspect(sliver).signed_volume > 0) sliver = meshes::inside_out(sliver);
    EXPECT_EQ(prepare_model(meshes::together(ring, sliver)).report.turned_triangles, 4u) << rising;
  }
}

TEST(PrepareModel, KeepsACavityWhoseFirstTriangleIsTurned) {
  IndexedMesh mesh = meshes::hollow_sphere(2);
  const Eigen::Index first_of_cavity = mesh.triangles.rows() / 2;
  std::swap(mesh.triangles(first_of_cavity, 1), mesh.triangles(first_of_cavity, 2));
  const Model model = prepare_model(mesh);
  expect_model(model);
  EXPECT_EQ(model.report.turned_triangles, 1u);
}

TEST(PrepareModel, KeepsEveryOneOfManyCavities) {
  IndexedMesh mesh = meshes::box({0, 0, 0}, {10, 10, 10});
  const IndexedMesh bubble = meshes::inside_out(meshes::icosphere(0));
  for (int k = 0; k < 125; ++k) {
    mesh =
        meshes::together(mesh, meshes::moved(bubble, 0.75, Vector3(k % 5, k / 5 % 5, k / 25) * 1.9 + Vector3::Ones()));
  }
  const Model model = prepare_model(mesh);
  expect_model(model);
  EXPECT_EQ(model.report.turned_triangles, 0u);
  EXPECT_LT(model.volume, 1000);
}

TEST(PrepareModel, KeepsACavityThatTouchesItsShell) {
  // The cavity's corner is in the middle of a wall, exactly in the plane of its triangles.
  const IndexedMesh cavity = meshes::inside_out(meshes::moved(meshes::tetrahedron(), 1, {2, 2, 0}));
  const Model model = prepare_model(meshes::together(meshes::box({0, 0, 0}, {4, 5, 6}), cavity));
  expect_model(model);
  EXPECT_EQ(model.report.turned_triangles, 0u);
}

TEST(PrepareModel, KeepsAnIslandInACavity) {
  const IndexedMesh mesh =
      meshes::together(meshes::hollow_sphere(2), meshes::moved(meshes::icosphere(2), 0.25, Vector3::Zero()));
  const Model model = prepare_model(mesh);
  expect_model(model);
  EXPECT_EQ(model.report.turned_triangles, 0u);
}

TEST(PrepareModel, DoesNotDependOnTheOrderInWhatItTurns) {
  const IndexedMesh mesh =
      meshes::together(meshes::inside_out(meshes::hollow_sphere(2)), meshes::moved(meshes::icosphere(1), 1, {5, 0, 0}));
  for (unsigned seed = 0; seed < 10; ++seed) {
    const Model model = prepare_model(meshes::shuffled(mesh, seed));
    expect_model(model);
    EXPECT_EQ(model.report.turned_triangles, 2 * triangles_of(meshes::icosphere(2)));
  }
}

TEST(PrepareModel, WorksFarFromTheOriginAndAtSmallAndLargeScale) {
  for (const double scale : {1e-90, 1e-6, 1e6, 1e90}) {
    const Model model = prepare_model(meshes::moved(meshes::inside_out(meshes::icosphere(2)), scale, Vector3::Zero()));
    EXPECT_NEAR(model.volume / (scale * scale * scale), 4.05, 0.05) << scale;
  }
  const Model model = prepare_model(meshes::moved(meshes::hollow_sphere(2), 1, {1e8, 1e8, 1e8}));
  EXPECT_NEAR(model.volume, prepare_model(meshes::hollow_sphere(2)).volume, 1e-5);
}

TEST(PrepareModel, RefusesAnOpenModelAndTellsCountPlaceAndNextStep) {
  const IndexedMesh mesh = meshes::without_triangle(meshes::tetrahedron(), 3);
  const Error error = expect_error([&] { prepare_model(mesh); }, ErrorCode::mesh_open,
                                   {"open: 3 open edges", "(0.5, 0.5, 0)", "close the holes"});
  EXPECT_EQ(error.place().point, Vector3(0.5, 0.5, 0));
}

TEST(PrepareModel, RefusesAModelThatIsNotManifoldAndTellsCountPlaceAndNextStep) {
  const Error error = expect_error([] { prepare_model(meshes::bow_tie_edge()); }, ErrorCode::mesh_non_manifold,
                                   {"1 edge with more than two triangles", "(1, 1, 0.5)", "separate"});
  EXPECT_EQ(error.place().point, Vector3(1, 1, 0.5));
}

TEST(PrepareModel, RefusesAnEdgeWhoseTrianglesGoRoundBothItsEndsInOneFan) {
  const Error error = expect_error([] { prepare_model(meshes::seamed_pinch()); }, ErrorCode::mesh_non_manifold,
                                   {"1 edge with more than two triangles", "(1, 1, 1.5)"});
  EXPECT_EQ(error.place().point, Vector3(1, 1, 1.5));
}

TEST(PrepareModel, TellsOfBothWhereAModelIsOpenAndNotManifold) {
  const IndexedMesh mesh = meshes::without_triangle(meshes::bow_tie_edge(), 0);
  expect_error([&] { prepare_model(mesh); }, ErrorCode::mesh_open,
               {"3 open edges", "1 edge with more than two triangles", "(1, 1, 0.5)", "close the holes and separate"});
}

TEST(PrepareModel, RefusesOneSidedSurfaces) {
  const Error error = expect_error([] { prepare_model(meshes::klein_bottle(12, 9)); }, ErrorCode::mesh_not_orientable,
                                   {"no orientation", "the edge at (", "remesh"});
  EXPECT_TRUE(error.place().point);
  expect_error([] { prepare_model(meshes::moebius_band(12)); }, ErrorCode::mesh_open, {"24 open edges"});
}

TEST(PrepareModel, RefusesASurfaceWithoutVolume) {
  IndexedMesh flat = meshes::icosphere(2);
  flat.points.col(0) += 0.31 * flat.points.col(2);  // or its halves would fall together
  flat.points.col(1) += 0.17 * flat.points.col(2);
  flat.points.col(2) = 0.3 * flat.points.col(0) + 0.7 * flat.points.col(1);
  expect_error([&] { prepare_model(flat); }, ErrorCode::mesh_empty, {"no volume", "thickness"});
}

TEST(PrepareModel, RefusesAVolumeThatNoDoubleHolds) {
  for (const double scale : {1e-200, 1e200}) {
    const IndexedMesh mesh = meshes::moved(meshes::icosphere(1), scale, Vector3::Zero());
    expect_error([&] { prepare_model(mesh); }, ErrorCode::mesh_not_finite, {"reaches from (", "scale it"});
  }
}

TEST(PrepareModel, AcceptsAThinPlate) {
  const Model model = prepare_model(meshes::moved(meshes::box({0, 0, 0}, {1, 1, 1e-9}), 1, {0.1, 0.2, 0.3}));
  EXPECT_NEAR(model.volume, 1e-9, 1e-15);
}

TEST(PrepareModel, FingerprintsTheInput) {
  const IndexedMesh mesh = meshes::torus(3, 1, 16, 8);
  const std::uint64_t same = prepare_model(mesh).fingerprint;
  EXPECT_EQ(prepare_model(mesh).fingerprint, same);
  EXPECT_NE(prepare_model(meshes::shuffled(mesh, 1)).fingerprint, same);
  EXPECT_NE(prepare_model(meshes::inside_out(mesh)).fingerprint, same);
  IndexedMesh nudged = mesh;
  double& last = nudged.points(nudged.points.rows() - 1, 2);
  last = std::nextafter(last, 10.0);
  EXPECT_NE(prepare_model(nudged).fingerprint, same);
}

}  // namespace
}  // namespace cagewright
