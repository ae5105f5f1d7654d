// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/error/error.h"
#include "core/mesh/weld.h"
#include "core/tests/expect_error.h"
#include "core/tests/meshes.h"

namespace cagewright {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(Weld, MergesVerticesThatEveryTriangleHasForItself) {
  const IndexedMesh sphere = meshes::icosphere(2);
  const WeldedMesh welded = weld(meshes::with_own_vertices(sphere));
  EXPECT_EQ(welded.mesh.points.rows(), sphere.points.rows());
  EXPECT_EQ(welded.welded_vertices, static_cast<std::size_t>(sphere.triangles.size() - sphere.points.rows()));
  EXPECT_EQ(welded.degenerate_triangles, 0u);
}

TEST(Weld, LeavesACleanMeshAsItIs) {
  const IndexedMesh torus = meshes::torus(3, 1, 12, 6);
  const WeldedMesh welded = weld(torus);
  EXPECT_EQ(welded.mesh.points, torus.points);
  EXPECT_EQ(welded.mesh.triangles, torus.triangles);
}

TEST(Weld, TakesMinusZeroForZero) {
  IndexedMesh mesh = meshes::with_own_vertices(meshes::tetrahedron());
  for (double& x : mesh.points.row(0)) x = x == 0 ? -0.0 : x;
  EXPECT_EQ(weld(mesh).mesh.points.rows(), 4);
}

TEST(Weld, KeepsVerticesApartThatDifferInTheLastBit) {
  IndexedMesh mesh = meshes::with_own_vertices(meshes::tetrahedron());
  mesh.points(3, 0) = std::nextafter(mesh.points(3, 0), 2.0);
  EXPECT_EQ(weld(mesh).mesh.points.rows(), 5);
}

TEST(Weld, KeepsTheFirstOfEqualVerticesAndTheOrder) {
  IndexedMesh mesh{Points(6, 3), Triangles(2, 3)};
  mesh.points << 9, 9, 9, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 1;
  mesh.triangles << 5, 3, 2, 4, 2, 1;
  const WeldedMesh welded = weld(mesh);
  Points points(4, 3);
  points << 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1;
  Triangles triangles(2, 3);
  triangles << 3, 0, 1, 2, 1, 0;
  EXPECT_EQ(welded.mesh.points, points);
  EXPECT_EQ(welded.mesh.triangles, triangles);
  EXPECT_EQ(welded.given, mesh.triangles);
  EXPECT_EQ(welded.welded_vertices, 1u);
  EXPECT_EQ(welded.unused_vertices, 1u);
}

TEST(Weld, DropsTrianglesWithTwoCornersAtOnePosition) {
  IndexedMesh mesh = meshes::together(meshes::tetrahedron(), meshes::tetrahedron());
  mesh.triangles.conservativeResize(6, 3);
  mesh.triangles.row(4) << 0, 0, 1;
  mesh.triangles.row(5) << 1, 2, 5;  // 5 lies where 1 does
  const WeldedMesh welded = weld(mesh);
  EXPECT_EQ(welded.mesh.triangles, meshes::tetrahedron().triangles);
  EXPECT_EQ(welded.degenerate_triangles, 2u);
}

TEST(Weld, KeepsTrianglesWithoutAreaWhoseCornersDiffer) {
  IndexedMesh mesh{Points(3, 3), Triangles(1, 3)};
  mesh.points << 0, 0, 0, 1, 0, 0, 2, 0, 0;
  mesh.triangles << 0, 1, 2;
  EXPECT_EQ(weld(mesh).mesh.triangles.rows(), 1);
}

TEST(Weld, AccountsForEveryVertex) {
  IndexedMesh mesh = meshes::with_own_vertices(meshes::perforated_plate(2));
  mesh.points.conservativeResize(mesh.points.rows() + 3, 3);
  mesh.points.bottomRows(3) << 7, 7, 7, 7, 7, 7, 8, 8, 8;  // two of them equal, none used
  const WeldedMesh welded = weld(mesh);
  EXPECT_EQ(welded.unused_vertices, 2u);
  EXPECT_EQ(static_cast<std::size_t>(welded.mesh.points.rows()) + welded.welded_vertices + welded.unused_vertices,
            static_cast<std::size_t>(mesh.points.rows()));
}

TEST(Weld, RefusesAMeshWithoutTriangles) {
  const IndexedMesh points_only{meshes::tetrahedron().points, Triangles(0, 3)};
  expect_error([&] { weld(points_only); }, ErrorCode::mesh_empty, {"no triangle", "choose a mesh"});
}

TEST(Weld, RefusesAMeshOfDegenerateTriangles) {
  const IndexedMesh mesh{Points::Zero(3, 3), (Triangles(1, 3) << 0, 1, 2).finished()};
  expect_error([&] { weld(mesh); }, ErrorCode::mesh_empty, {"1 triangle", "same position", "choose a mesh"});
}

TEST(Weld, NamesTheVertexThatIsNotFinite) {
  for (const double bad : {std::nan(""), infinity, -infinity}) {
    IndexedMesh mesh = meshes::icosphere(1);
    mesh.points(17, 1) = bad;
    const Error error =
        expect_error([&] { weld(mesh); }, ErrorCode::mesh_not_finite, {"vertex 17", "repair or remove"});
    EXPECT_EQ(error.place().element, 17u);
  }
}

TEST(Weld, NamesTheTriangleAndTheIndexOutOfRange) {
  for (const int bad : {-1, 4, 1000}) {
    IndexedMesh mesh = meshes::tetrahedron();
    mesh.triangles(2, 1) = bad;
    const Error error = expect_error([&] { weld(mesh); }, ErrorCode::mesh_index,
                                     {"triangle 2", "vertex " + std::to_string(bad), "4 vertices", "repair"});
    EXPECT_EQ(error.place().element, 2u);
  }
}

TEST(Weld, RefusesIndicesIntoNoVerticesAtAll) {
  const IndexedMesh mesh{Points(0, 3), Triangles::Zero(1, 3)};
  expect_error([&] { weld(mesh); }, ErrorCode::mesh_index, {"triangle 0"});
}

}  // namespace
}  // namespace cagewright
