// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/enclose/box_tree.h"
#include "core/enclose/triangle_distance.h"
#include "core/enclose/triangle_intersection.h"
#include "core/tests/meshes.h"
#include "core/tests/random_numbers.h"

namespace cagewright {
namespace {

// The reference: separating axes in integers. Two triangles are apart exactly where their projections on one of these
// axes are: the normals, the cross products of edges, and, for coplanar ones, the edges' normals in the plane.
using Integer3 = std::array<long long, 3>;
using IntegerTriangle = std::array<Integer3, 3>;

Integer3 minus(const Integer3& a, const Integer3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Integer3 cross(const Integer3& a, const Integer3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
long long dot(const Integer3& a, const Integer3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

bool separates(const Integer3& axis, const IntegerTriangle& s, const IntegerTriangle& t) {
  std::array<long long, 3> on_s{}, on_t{};
  for (std::size_t i = 0; i < 3; ++i) {
    on_s[i] = dot(axis, s[i]);
    on_t[i] = dot(axis, t[i]);
  }
  const auto [s_low, s_high] = std::minmax_element(on_s.begin(), on_s.end());
  const auto [t_low, t_high] = std::minmax_element(on_t.begin(), on_t.end());
  return *s_high < *t_low || *t_high < *s_low;
}

Integer3 normal_of(const IntegerTriangle& t) { return cross(minus(t[1], t[0]), minus(t[2], t[0])); }

bool reference_meets(const IntegerTriangle& s, const IntegerTriangle& t) {
  std::vector<Integer3> axes = {normal_of(s), normal_of(t)};
  for (std::size_t i = 0; i < 3; ++i) {
    const Integer3 s_edge = minus(s[(i + 1) % 3], s[i]), t_edge = minus(t[(i + 1) % 3], t[i]);
    axes.push_back(cross(s_edge, normal_of(s)));
    axes.push_back(cross(t_edge, normal_of(t)));
    for (std::size_t k = 0; k < 3; ++k) axes.push_back(cross(s_edge, minus(t[(k + 1) % 3], t[k])));
  }
  return std::none_of(axes.begin(), axes.end(), [&](const Integer3& axis) { return separates(axis, s, t); });
}

Vector3 real(const Integer3& p) {
  return {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
}
Triangle3 real(const IntegerTriangle& t) { return {real(t[0]), real(t[1]), real(t[2])}; }

// On a grid so small that corners, edges and planes often fall together.
IntegerTriangle random_triangle(Random& random, int grid) {
  IntegerTriangle t{};
  do {
    for (Integer3& corner : t)
      for (long long& x : corner) x = random.below(grid);
  } while (normal_of(t) == Integer3{0, 0, 0});
  return t;
}

TEST(TrianglesMeet, AgreesWithSeparatingAxesInIntegers) {
  Random random(1);
  int meeting = 0;
  for (int trial = 0; trial < 200000; ++trial) {
    const int grid = 2 + trial % 4;
    const IntegerTriangle s = random_triangle(random, grid), t = random_triangle(random, grid);
    const bool expected = reference_meets(s, t);
    meeting += expected;
    ASSERT_EQ(triangles_meet(real(s), real(t)), expected) << trial;
    ASSERT_EQ(triangles_meet(real(t), real(s)), expected) << trial;
  }
  EXPECT_GT(meeting, 20000);
  EXPECT_LT(meeting, 180000);
}

TEST(TrianglesMeet, TellsTouchingFromAHairApart) {
  const Triangle3 floor = {Vector3(0, 0, 0), Vector3(1, 0, 0), Vector3(0, 1, 0)};
  const auto above = [](double z) -> Triangle3 { return {Vector3(0.3, 0.3, z), Vector3(0, 0, 1), Vector3(1, 1, 1)}; };
  EXPECT_TRUE(triangles_meet(floor, above(0)));
  EXPECT_FALSE(triangles_meet(floor, above(5e-324)));
  EXPECT_TRUE(triangles_meet(floor, above(-5e-324)));
  const double past = std::nextafter(0.5, 1.0);
  const auto beside = [](double x, double y) -> Triangle3 {
    return {Vector3(x, y, 0), Vector3(2, 2, 0), Vector3(2, 1, 1)};
  };
  EXPECT_TRUE(triangles_meet(floor, beside(0.5, 0.5)));
  EXPECT_FALSE(triangles_meet(floor, beside(past, 0.5)));
}

TEST(TrianglesMeet, KnowsDegenerateTriangles) {
  EXPECT_TRUE(is_degenerate({Vector3(0, 0, 0), Vector3(1, 1, 1), Vector3(3, 3, 3)}));
  EXPECT_TRUE(is_degenerate({Vector3(0.1, 0, 0), Vector3(0.1, 0, 0), Vector3(3, 3, 3)}));
  EXPECT_FALSE(is_degenerate({Vector3(0, 0, 0), Vector3(1, 1, 1), Vector3(3, 3, std::nextafter(3.0, 4.0))}));
}

// Two triangles of one mesh that share `shared` vertices, over the reference's triangles.
IndexedMesh mesh_of(const IntegerTriangle& s, const IntegerTriangle& t, int shared) {
  IndexedMesh mesh;
  mesh.points.resize(6 - shared, 3);
  mesh.triangles.resize(2, 3);
  for (int i = 0; i < 3; ++i) {
    mesh.points.row(i) = real(s[static_cast<std::size_t>(i)]).transpose();
    mesh.triangles(0, i) = i;
    mesh.triangles(1, i) = i < shared ? i : i + 3 - shared;
    if (i >= shared) mesh.points.row(i + 3 - shared) = real(t[static_cast<std::size_t>(i)]).transpose();
  }
  return mesh;
}

constexpr long long magnification = 1024;

Integer3 between(const Integer3& from, const Integer3& to) {
  Integer3 p{};
  for (std::size_t i = 0; i < 3; ++i) p[i] = from[i] + (to[i] - from[i]) / magnification;
  return p;
}
IntegerTriangle magnified(IntegerTriangle t) {
  for (Integer3& corner : t)
    for (long long& x : corner) x *= magnification;
  return t;
}

// On the grid, what two triangles have in common beyond a shared vertex reaches farther than a thousandth of the way to
// the opposite edge: it meets what is left of one of them when that much is cut off at the vertex.
TEST(TrianglesOfMeshMeet, CountsWhatIsBeyondASharedVertex) {
  Random random(2);
  int meeting = 0;
  for (int trial = 0; trial < 50000; ++trial) {
    const int grid = 2 + trial % 3;
    const IntegerTriangle s = random_triangle(random, grid);
    IntegerTriangle t = random_triangle(random, grid);
    t[0] = s[0];
    if (normal_of(t) == Integer3{0, 0, 0}) continue;
    const IntegerTriangle large_s = magnified(s), large_t = magnified(t);
    const Integer3 near_b = between(large_s[0], large_s[1]), near_c = between(large_s[0], large_s[2]);
    const bool expected = reference_meets({near_b, large_s[1], large_s[2]}, large_t) ||
                          reference_meets({near_b, large_s[2], near_c}, large_t);
    meeting += expected;
    const IndexedMesh mesh = mesh_of(s, t, 1);
    ASSERT_EQ(triangles_of_mesh_meet(mesh, 0, 1), expected) << trial;
    ASSERT_EQ(triangles_of_mesh_meet(mesh, 1, 0), expected) << trial;
  }
  EXPECT_GT(meeting, 1000);
}

TEST(TrianglesOfMeshMeet, CountsOnlyWhatIsFoldedFlatAcrossASharedEdge) {
  const IntegerTriangle s = {Integer3{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  const auto meets = [&](const Integer3& third) {
    return triangles_of_mesh_meet(mesh_of(s, {s[0], s[1], third}, 2), 0, 1);
  };
  EXPECT_TRUE(meets({1, 3, 0}));
  EXPECT_TRUE(meets({9, 1, 0}));
  EXPECT_FALSE(meets({1, -3, 0}));
  EXPECT_FALSE(meets({1, 3, 1}));
  EXPECT_FALSE(meets({1, -3, -1}));
}

TEST(TrianglesOfMeshMeet, CountsTheSameTriangleTwice) {
  const IntegerTriangle s = {Integer3{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  EXPECT_TRUE(triangles_of_mesh_meet(mesh_of(s, s, 3), 0, 1));
}

// Also of slivers, whose normals are rounding.
TEST(BoxTree, MissesNoTriangleThatIsNear) {
  Random random(9);
  const IndexedMesh ball = meshes::icosphere(3);
  const BoxTree tree(ball);
  const auto corners = [&](int t) -> Triangle3 {
    return {ball.points.row(ball.triangles(t, 0)), ball.points.row(ball.triangles(t, 1)),
            ball.points.row(ball.triangles(t, 2))};
  };
  long near = 0;
  for (int trial = 0; trial < 400; ++trial) {
    const double thinness = std::pow(10.0, -(trial % 20));
    const Vector3 a = random.uniform(0.5, 1.2) * random.direction(), along = random.direction();
    const Triangle3 query = {a, Vector3(a + along), Vector3(a + 0.4 * along + thinness * random.direction())};
    const double distance = trial % 2 ? 0.05 : 0.0;
    std::vector<bool> visited(static_cast<std::size_t>(ball.triangles.rows()), false);
    tree.visit_near(query, distance, [&](int t) {
      visited[static_cast<std::size_t>(t)] = true;
      return false;
    });
    for (int t = 0; t < static_cast<int>(ball.triangles.rows()); ++t) {
      const bool meets = is_degenerate(query) ? segment_meets_triangle(query[0], query[1], corners(t))
                                              : triangles_meet(query, corners(t));
      if (!meets && !(triangle_distance(query, corners(t)) < distance)) continue;
      ++near;
      ASSERT_TRUE(visited[static_cast<std::size_t>(t)]) << trial << ", triangle " << t;
    }
  }
  EXPECT_GT(near, 1000);
}

// Between slivers, too, of which a prism knows a capsule only.
TEST(Prism, PartsNothingThatIsNear) {
  Random random(11);
  int near = 0, parted = 0;
  for (int i = 0; i < 20000; ++i) {
    const auto point = [&](double size) { return Vector3(size * random.direction() * random.uniform(0, 1)); };
    const double thinness = i % 2 == 0 ? 1 : std::pow(10, random.uniform(-9, -3.1));
    const Vector3 a = point(1), b = point(1),
                  apex = a + random.uniform(-0.5, 1.5) * (b - a) + point(thinness * (b - a).norm());
    const Triangle3 t = {a, b, apex};
    Box3 box(a);
    box.extend(b).extend(apex);
    ASSERT_TRUE(i % 2 == 0 || is_thin(t, box));
    const Vector3 center = point(1);
    const Triangle3 other = {center, center + point(0.1), center + point(0.1)};
    const double distance = random.uniform(0, 0.3), apart = triangle_distance(t, other);
    const Prism prism(t, box);
    if (apart <= distance) {
      ++near;
      EXPECT_FALSE(prism.parts(other, distance)) << i;
    } else {
      parted += prism.parts(other, distance);
    }
    const double of_center = (at_barycentric(t, nearest_on_triangle(center, t)) - center).norm();
    EXPECT_FALSE(prism.parts_ball(center, of_center + 1e-12)) << i;
    EXPECT_TRUE(i % 2 == 0 || prism.parts_ball(center, of_center - 1e-2)) << i;
  }
  EXPECT_GT(near, 2000);
  EXPECT_GT(parted, 2000);
}

}  // namespace
}  // namespace cagewright
