// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/measure/cage_shape.h"
#include "core/tests/meshes.h"
#include "core/tests/shapes.h"

namespace cagewright {
namespace {

constexpr double pi = std::numbers::pi;

IndexedMesh regular_tetrahedron() {
  IndexedMesh mesh = meshes::tetrahedron();
  mesh.points << 1, 1, 1, 1, -1, -1, -1, 1, -1, -1, -1, 1;
  const Vector3 a = mesh.points.row(mesh.triangles(0, 0)), b = mesh.points.row(mesh.triangles(0, 1)),
                c = mesh.points.row(mesh.triangles(0, 2));
  return a.dot(b.cross(c)) > 0 ? mesh : meshes::inside_out(mesh);
}

TEST(CageShape, KnowsCubeAndTetrahedron) {
  const CageShape cube = measure_shape(meshes::box({0, 0, 0}, {1, 1, 1}));
  EXPECT_NEAR(cube.least_dihedral.value(), pi / 2, 1e-15);
  EXPECT_NEAR(cube.greatest_dihedral.value(), pi, 1e-15);
  EXPECT_NEAR(cube.least_aspect, (1 + std::sqrt(2)) / std::sqrt(3), 1e-14);
  EXPECT_NEAR(cube.greatest_aspect, (1 + std::sqrt(2)) / std::sqrt(3), 1e-14);
  const CageShape tetrahedron = measure_shape(regular_tetrahedron());
  EXPECT_NEAR(tetrahedron.least_dihedral.value(), std::acos(1.0 / 3), 1e-14);
  EXPECT_NEAR(tetrahedron.greatest_dihedral.value(), std::acos(1.0 / 3), 1e-14);
  EXPECT_NEAR(tetrahedron.least_aspect, 1, 1e-14);
  EXPECT_NEAR(tetrahedron.greatest_aspect, 1, 1e-14);
}

TEST(CageShape, MeasuresDihedralsOnTheInside) {
  EXPECT_NEAR(measure_shape(meshes::perforated_plate(1)).greatest_dihedral.value(), 3 * pi / 2, 1e-14);
  const CageShape inside_out = measure_shape(meshes::inside_out(meshes::box({0, 0, 0}, {1, 1, 1})));
  EXPECT_NEAR(inside_out.least_dihedral.value(), pi, 1e-14);
  EXPECT_NEAR(inside_out.greatest_dihedral.value(), 3 * pi / 2, 1e-14);
}

TEST(CageShape, TellsAFoldFromASharpEdge) {
  IndexedMesh mesh{Points(4, 3), Triangles(2, 3)};
  mesh.triangles << 0, 1, 2, 1, 0, 3;
  for (const double opening : {0.001, 1.0, 3.0, 4.0, 6.0}) {
    mesh.points << 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, std::cos(opening), -std::sin(opening);
    const CageShape shape = measure_shape(mesh);
    EXPECT_NEAR(shape.least_dihedral.value(), opening, 1e-12);
    EXPECT_NEAR(shape.greatest_dihedral.value(), opening, 1e-12);
  }
}

TEST(CageShape, GrowsWithTheLengthOfATriangle) {
  IndexedMesh mesh{Points(3, 3), Triangles(1, 3)};
  mesh.triangles << 0, 1, 2;
  for (const double length : {10.0, 1e3, 1e6}) {
    mesh.points << 0, 0, 0, length, 0, 0, length / 2, 1, 0;
    const double leg = std::hypot(length / 2, 1), radius = length / (length + 2 * leg);
    const CageShape shape = measure_shape(mesh);
    EXPECT_NEAR(shape.greatest_aspect, length / (2 * std::sqrt(3) * radius), 1e-9 * length);
    EXPECT_FALSE(shape.least_dihedral) << "no edge has two triangles";
  }
  mesh.points.row(2) << 4, 0, 0;
  EXPECT_TRUE(std::isinf(measure_shape(mesh).greatest_aspect));
}

TEST(CageShape, StaysUnderMotionsScalesOrderAndSplitVertices) {
  const shapes::SlidBody body = shapes::fork(1);
  const CageShape plain = measure_shape(body.mesh);
  const auto expect_same = [&](const IndexedMesh& mesh, double tolerance) {
    const CageShape other = measure_shape(mesh);
    EXPECT_NEAR(other.least_dihedral.value(), plain.least_dihedral.value(), tolerance);
    EXPECT_NEAR(other.greatest_dihedral.value(), plain.greatest_dihedral.value(), tolerance);
    EXPECT_NEAR(other.least_aspect / plain.least_aspect, 1, tolerance);
    EXPECT_NEAR(other.greatest_aspect / plain.greatest_aspect, 1, tolerance);
  };
  for (unsigned seed = 1; seed <= 5; ++seed) {
    expect_same(shapes::moved(body.mesh, shapes::random_motion(seed, 7, 1)), 1e-6);
    expect_same(meshes::shuffled(body.mesh, seed), 1e-12);
  }
  expect_same(meshes::with_own_vertices(body.mesh), 1e-12);
  for (const double scale : {1e-200, 1e200}) expect_same(meshes::moved(body.mesh, scale, Vector3::Zero()), 1e-9);
}

}  // namespace
}  // namespace cagewright
