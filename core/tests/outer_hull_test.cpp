// SPDX-License-Identifier: BSD-3-Clause
#include "core/enclose/outer_hull.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <set>

#include "core/enclose/box_tree.h"
#include "core/enclose/certificate.h"
#include "core/enclose/winding.h"
#include "core/tests/cage_checks.h"
#include "core/tests/meshes.h"
#include "core/tests/random_numbers.h"
#include "core/tests/shapes.h"

namespace cagewright {
namespace {

using Box = Eigen::AlignedBox3d;

IndexedMesh all_of(const std::vector<IndexedMesh>& meshes) {
  IndexedMesh all = meshes.front();
  for (std::size_t k = 1; k < meshes.size(); ++k) all = meshes::together(all, meshes[k]);
  return all;
}

IndexedMesh boxes_of(const std::vector<Box>& boxes) {
  std::vector<IndexedMesh> meshes;
  for (const Box& box : boxes) meshes.push_back(meshes::box(box.min(), box.max()));
  return all_of(meshes);
}

// Closed, outward, without triangles that meet or have no area; of a mesh alone.
void expect_sound(const IndexedMesh& mesh) {
  const Certificate certificate = certify(mesh, mesh);
  EXPECT_TRUE(certificate.closed);
  EXPECT_TRUE(certificate.degenerate_triangles.empty());
  EXPECT_TRUE(certificate.self_intersections.empty()) << certificate.self_intersections.size();
}

void expect_same(const OuterHull& hull, const IndexedMesh& mesh) {
  EXPECT_EQ(hull.mesh.points, mesh.points);
  EXPECT_EQ(hull.mesh.triangles, mesh.triangles);
  EXPECT_TRUE(hull.touching.empty());
  for (std::size_t t = 0; t < hull.triangle_source.size(); ++t) EXPECT_EQ(hull.triangle_source[t], static_cast<int>(t));
  for (std::size_t v = 0; v < hull.vertex_source.size(); ++v) EXPECT_EQ(hull.vertex_source[v], static_cast<int>(v));
}

// The volume that cannot be reached from infinity, by the cells between all the boxes' planes.
double filled_volume(const std::vector<Box>& boxes) {
  std::array<std::vector<double>, 3> cuts;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const Box& box : boxes)
      for (const double x : {box.min()[static_cast<int>(axis)], box.max()[static_cast<int>(axis)]})
        cuts[axis].push_back(x);
    std::sort(cuts[axis].begin(), cuts[axis].end());
    cuts[axis].erase(std::unique(cuts[axis].begin(), cuts[axis].end()), cuts[axis].end());
    cuts[axis].insert(cuts[axis].begin(), cuts[axis].front() - 1);
    cuts[axis].push_back(cuts[axis].back() + 1);
  }
  const auto size = [&](std::size_t axis) { return static_cast<int>(cuts[axis].size()) - 1; };
  using Cell = std::array<int, 3>;
  const auto extent = [&](const Cell& cell) {
    Box box;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto k = static_cast<std::size_t>(cell[axis]);
      box.min()[static_cast<int>(axis)] = cuts[axis][k];
      box.max()[static_cast<int>(axis)] = cuts[axis][k + 1];
    }
    return box;
  };
  const auto is_solid = [&](const Cell& cell) {
    const Vector3 middle = extent(cell).center();
    return std::any_of(boxes.begin(), boxes.end(), [&](const Box& box) { return box.contains(middle); });
  };
  std::set<Cell> outside = {{0, 0, 0}};
  std::vector<Cell> open = {{0, 0, 0}};
  while (!open.empty()) {
    const Cell cell = open.back();
    open.pop_back();
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (const int step : {-1, 1}) {
        Cell next = cell;
        next[axis] += step;
        if (next[axis] < 0 || next[axis] >= size(axis) || is_solid(next) || !outside.insert(next).second) continue;
        open.push_back(next);
      }
  }
  double volume = 0;
  for (int i = 0; i < size(0); ++i)
    for (int j = 0; j < size(1); ++j)
      for (int k = 0; k < size(2); ++k)
        if (outside.count({i, j, k}) == 0) volume += extent({i, j, k}).volume();
  return volume;
}

Box random_box(Random& random, bool on_grid) {
  Box box;
  for (int axis = 0; axis < 3; ++axis) {
    double a = random.uniform(0, 1), b = a + random.uniform(0.1, 0.6);
    if (on_grid) {
      a = std::floor(4 * a);
      b = std::floor(a + 1 + 3 * random.uniform(0, 1));
    }
    box.min()[axis] = a;
    box.max()[axis] = b;
  }
  return box;
}

TEST(OuterHull, LeavesAMeshWithoutSelfIntersectionsAsItIs) {
  for (const IndexedMesh& mesh : {meshes::tetrahedron(), meshes::icosphere(2), meshes::torus(2, 0.7, 12, 8),
                                  meshes::perforated_plate(2), meshes::capsule(1, 2, 12, 4)})
    expect_same(outer_hull(mesh), mesh);
  for (const shapes::SlidBody& body : shapes::slid_bodies()) expect_same(outer_hull(body.mesh), body.mesh);
}

TEST(OuterHull, KeepsAllComponentsThatLieBesideEachOther) {
  const IndexedMesh mesh =
      meshes::together(meshes::icosphere(1), meshes::moved(meshes::torus(2, 0.5, 9, 6), 1, Vector3(5, 1, 0)));
  expect_same(outer_hull(mesh), mesh);
}

TEST(OuterHull, SwallowsWhatLiesInside) {
  const IndexedMesh box = meshes::box({-2, -2, -2}, {2, 2, 2});
  expect_same(outer_hull(meshes::together(box, meshes::icosphere(1))), box);
  const OuterHull hull = outer_hull(meshes::together(meshes::icosphere(1), box));
  EXPECT_EQ(hull.mesh.points, box.points);
  EXPECT_EQ(hull.vertex_source.front(), 42);
  EXPECT_EQ(hull.triangle_source.front(), 80);
  EXPECT_EQ(outer_hull(meshes::hollow_sphere(1)).mesh.triangles.rows(), 80);
}

TEST(OuterHull, FacesOutwardWhateverTheMeshDoes) {
  const IndexedMesh sphere = meshes::icosphere(1);
  const OuterHull hull = outer_hull(meshes::inside_out(sphere));
  EXPECT_NEAR(checks::volume_of(hull.mesh), checks::volume_of(sphere), 1e-12);
}

// A box whose corner is pulled through its bottom: beside the line along which its sides cross, what is turned over
// touches what is not.
TEST(OuterHull, KeepsWhatIsTurnedOverApart) {
  IndexedMesh pulled = meshes::box({0, 0, 0}, {1, 1, 1});
  for (Eigen::Index v = 0; v < 8; ++v)
    if (pulled.points.row(v) == Eigen::RowVector3d(0, 0, 1)) pulled.points(v, 2) = -1;
  const OuterHull hull = outer_hull(pulled, 1e-3);
  expect_sound(hull.mesh);
  EXPECT_FALSE(hull.touching.empty());
}

TEST(OuterHull, OfTwoBarsThatCrossHasNoNeedlessTriangles) {
  const IndexedMesh bars =
      boxes_of({Box(Vector3(-3, -1, -1), Vector3(3, 1, 1)), Box(Vector3(-0.5, -3, -0.5), Vector3(0.5, 3, 0.5))});
  const OuterHull hull = outer_hull(bars);
  expect_sound(hull.mesh);
  EXPECT_NEAR(checks::volume_of(hull.mesh), 24 + 4, 1e-12);
  // Each bar's corners, and where they cross two squares, whose sides the diagonals of the sides cut in two.
  EXPECT_EQ(hull.mesh.points.rows(), 16 + 8 + 8);
  checks::expect_closed_manifold(hull.mesh.points, hull.mesh.triangles, 0);
  for (Eigen::Index v = 0; v < 16; ++v) EXPECT_EQ(hull.mesh.points.row(v), bars.points.row(v));
}

TEST(OuterHull, OfBoxesHasTheVolumeOfTheirUnion) {
  Random random(3);
  for (int trial = 0; trial < 60; ++trial) {
    SCOPED_TRACE(trial);
    std::vector<Box> boxes;
    for (int k = 0; k < 2 + trial % 9; ++k) boxes.push_back(random_box(random, false));
    const OuterHull hull = outer_hull(boxes_of(boxes));
    expect_sound(hull.mesh);
    EXPECT_NEAR(checks::volume_of(hull.mesh), filled_volume(boxes), 1e-12);
  }
}

TEST(OuterHull, OfBoxesThatShareFacesEdgesAndVerticesHasTheVolumeOfTheirUnion) {
  Random random(4);
  int touching = 0;
  for (int trial = 0; trial < 120; ++trial) {
    SCOPED_TRACE(trial);
    std::vector<Box> boxes;
    for (int k = 0; k < 2 + trial % 10; ++k) boxes.push_back(random_box(random, true));
    const IndexedMesh mesh = boxes_of(boxes);
    EXPECT_NEAR(checks::volume_of(outer_hull(mesh).mesh), filled_volume(boxes), 1e-9);
    const OuterHull apart = outer_hull(mesh, 1e-3);
    const Certificate certificate = certify(apart.mesh, apart.mesh);
    EXPECT_TRUE(certificate.closed);
    EXPECT_TRUE(certificate.degenerate_triangles.empty());
    touching += !certificate.self_intersections.empty();
    EXPECT_NEAR(checks::volume_of(apart.mesh), filled_volume(boxes), 0.2);
  }
  EXPECT_LE(touching, 2) << "sheets that are saddles where they touch";
}

struct Solid {
  IndexedMesh mesh;
  std::function<double(const Vector3&)> depth;  // > 0 inside
};

// A rod of `sides` flat sides, closed by flat ends.
Solid random_rod(Random& random) {
  const int sides = 3 + random.below(6);
  const double radius = random.uniform(0.1, 0.4), length = random.uniform(0.5, 2);
  const Eigen::Quaterniond turn = Eigen::Quaterniond::FromTwoVectors(Vector3::UnitZ(), random.direction());
  const Vector3 center(random.uniform(-0.6, 0.6), random.uniform(-0.6, 0.6), random.uniform(-0.6, 0.6));
  Solid rod;
  rod.mesh.points.resize(2 * sides + 2, 3);
  rod.mesh.triangles.resize(4 * sides, 3);
  const auto at = [&](double x, double y, double z) -> Eigen::RowVector3d {
    return (center + turn * Vector3(x, y, z)).transpose();
  };
  for (int i = 0; i < sides; ++i) {
    const double angle = 2 * std::numbers::pi * i / sides;
    const int j = (i + 1) % sides;
    rod.mesh.points.row(i) = at(radius * std::cos(angle), radius * std::sin(angle), -length / 2);
    rod.mesh.points.row(sides + i) = at(radius * std::cos(angle), radius * std::sin(angle), length / 2);
    rod.mesh.triangles.row(4 * i) << i, j, sides + j;
    rod.mesh.triangles.row(4 * i + 1) << i, sides + j, sides + i;
    rod.mesh.triangles.row(4 * i + 2) << j, i, 2 * sides;
    rod.mesh.triangles.row(4 * i + 3) << sides + i, sides + j, 2 * sides + 1;
  }
  rod.mesh.points.row(2 * sides) = at(0, 0, -length / 2);
  rod.mesh.points.row(2 * sides + 1) = at(0, 0, length / 2);
  rod.depth = [=](const Vector3& p) {
    const Vector3 q = turn.conjugate() * (p - center);
    double depth = length / 2 - std::abs(q.z());
    for (int i = 0; i < sides; ++i) {
      const double angle = 2 * std::numbers::pi * (i + 0.5) / sides;
      const double reach = radius * std::cos(std::numbers::pi / sides);
      depth = std::min(depth, reach - q.x() * std::cos(angle) - q.y() * std::sin(angle));
    }
    return depth;
  };
  return rod;
}

// By points: what is in a rod is in the hull; what is in the hull and in no rod is in a cavity, so it is rare.
TEST(OuterHull, OfRodsContainsThemAndLittleElse) {
  Random random(5);
  int in_hull = 0, in_cavity = 0;
  for (int trial = 0; trial < 25; ++trial) {
    SCOPED_TRACE(trial);
    std::vector<Solid> rods;
    std::vector<IndexedMesh> meshes;
    for (int k = 0; k < 2 + trial % 9; ++k) {
      rods.push_back(random_rod(random));
      meshes.push_back(rods.back().mesh);
    }
    const OuterHull hull = outer_hull(all_of(meshes));
    expect_sound(hull.mesh);
    const BoxTree tree(hull.mesh);
    const Winding winding(hull.mesh, tree);
    for (int sample = 0; sample < 1000; ++sample) {
      const Vector3 p(random.uniform(-1.2, 1.2), random.uniform(-1.2, 1.2), random.uniform(-1.2, 1.2));
      double depth = -1;
      for (const Solid& rod : rods) depth = std::max(depth, rod.depth(p));
      if (std::abs(depth) < 1e-9) continue;
      const bool is_in = winding.of(p).value_or(0) > 0;
      EXPECT_TRUE(is_in || depth < 0);
      in_hull += is_in;
      in_cavity += is_in && depth < 0;
    }
  }
  EXPECT_GT(in_hull, 1000);
  EXPECT_LT(in_cavity, in_hull / 100);
}

TEST(OuterHull, MovesWithTheMesh) {
  Random random(6);
  for (unsigned trial = 0; trial < 8; ++trial) {
    std::vector<IndexedMesh> rods;
    for (int k = 0; k < 5; ++k) rods.push_back(random_rod(random).mesh);
    const IndexedMesh mesh = all_of(rods);
    const shapes::Motion motion = shapes::random_motion(trial, 3, 2);
    const OuterHull here = outer_hull(mesh), there = outer_hull(shapes::moved(mesh, motion));
    ASSERT_EQ(here.mesh.points.rows(), there.mesh.points.rows());
    EXPECT_EQ(here.triangle_source, there.triangle_source);
    EXPECT_EQ(here.vertex_source, there.vertex_source);
    const double volume = checks::volume_of(here.mesh) * std::pow(motion.scale, 3);
    EXPECT_NEAR(checks::volume_of(there.mesh), volume, 1e-9 * volume);
  }
}

TEST(OuterHull, MindsNeitherFlatTrianglesNorDoubledVertices) {
  IndexedMesh bars =
      boxes_of({Box(Vector3(-3, -1, -1), Vector3(3, 1, 1)), Box(Vector3(-0.5, -3, -0.5), Vector3(0.5, 3, 0.5))});
  const OuterHull plain = outer_hull(bars);
  const OuterHull soup = outer_hull(meshes::with_own_vertices(bars));
  EXPECT_EQ(soup.mesh.points.rows(), plain.mesh.points.rows());
  EXPECT_EQ(soup.mesh.triangles.rows(), plain.mesh.triangles.rows());
  EXPECT_NEAR(checks::volume_of(soup.mesh), checks::volume_of(plain.mesh), 1e-12);
  expect_sound(soup.mesh);
  // A vertex on an edge: the triangle beyond it is folded flat.
  IndexedMesh flat = meshes::tetrahedron();
  flat.points.conservativeResize(5, 3);
  flat.points.row(4) = (flat.points.row(0) + flat.points.row(1)) / 2;
  const Eigen::Index last = flat.triangles.rows();
  flat.triangles.conservativeResize(last + 2, 3);
  for (Eigen::Index t = 0; t < last; ++t) {
    const Eigen::RowVector3i corners = flat.triangles.row(t);
    for (int i = 0; i < 3; ++i)
      if (corners(i) == 0 && corners((i + 1) % 3) == 1) {
        flat.triangles.row(t) << 0, 4, corners((i + 2) % 3);
        flat.triangles.row(last) << 4, 1, corners((i + 2) % 3);
        flat.triangles.row(last + 1) << 0, 1, 4;
      }
  }
  const OuterHull hull = outer_hull(flat);
  checks::expect_closed_manifold(hull.mesh.points, hull.mesh.triangles, 0);
  EXPECT_NEAR(checks::volume_of(hull.mesh), 1.0 / 6, 1e-15);
}

TEST(OuterHull, DrawsSheetsThatTouchApart) {
  const Box unit(Vector3(0, 0, 0), Vector3(1, 1, 1));
  const auto beside = [&](double x, double y, double z, double size = 1) {
    return boxes_of({unit, Box(Vector3(x, y, z), Vector3(x + size, y + size, z + size))});
  };
  // Sharing a face: one body. An edge, a vertex, an edge on a face, a vertex on an edge: two.
  EXPECT_TRUE(outer_hull(beside(1, 0, 0)).touching.empty());
  EXPECT_EQ(outer_hull(beside(1, 0, 0)).mesh.points.rows(), 12);
  for (const IndexedMesh& mesh : {beside(1, 1, 0), beside(1, 1, 1), beside(1, 1, 0.25, 0.5), beside(1, 1, -0.5)}) {
    const OuterHull touching = outer_hull(mesh), apart = outer_hull(mesh, 0.01);
    EXPECT_FALSE(touching.touching.empty());
    EXPECT_FALSE(certify(mesh, touching.mesh).closed && certify(mesh, touching.mesh).self_intersections.empty());
    expect_sound(apart.mesh);
    EXPECT_EQ(checks::components_of(apart.mesh.triangles), 2);
    EXPECT_NEAR(checks::volume_of(touching.mesh), checks::volume_of(mesh), 1e-12);
  }
}

}  // namespace
}  // namespace cagewright
