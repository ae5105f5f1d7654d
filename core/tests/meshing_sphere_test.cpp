// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/mesh/predicates.h"
#include "core/meshing/convex_hull.h"
#include "core/meshing/flip.h"
#include "core/meshing/meshing.h"
#include "core/meshing/projection_center.h"
#include "core/meshing/spherical_triangulation.h"
#include "core/tests/cage_checks.h"
#include "core/tests/expect_error.h"
#include "core/tests/random_numbers.h"

namespace cagewright {
namespace {

Bound random_bound(Random& random, int slide) {
  Bound bound;
  const Vector3 out = random.direction();
  bound.outward = (out + 0.3 * random.direction()).normalized();
  const Vector3 p = random.uniform(0.1, 0.8) * bound.outward.cross(random.direction()).normalized();
  const Vector3 q = random.uniform(0.1, 0.8) * bound.outward.cross(p).normalized();
  const Vector3 center = random.uniform(0.7, 2) * out;
  bound.corners = {center + p + q, center - p + q, center - p - q, center + p - q};
  for (int i = 0; i < 4; ++i) bound.vertices[static_cast<std::size_t>(i)] = 4 * slide + i;
  bound.slide = slide;
  return bound;
}

// Bounds round the origin that it sees side by side, or none where the dice fell badly.
Bounds random_bounds(Random& random, int count) {
  Bounds bounds;
  for (int tries = 0; tries < 60 && static_cast<int>(bounds.list.size()) < count; ++tries) {
    bounds.list.push_back(random_bound(random, static_cast<int>(bounds.list.size())));
    if (bounds.list.size() < 2) continue;
    for (std::size_t i = 0; i + 1 < bounds.list.size(); ++i) {
      const Bound& a = bounds.list[i];
      const Bound& b = bounds.list.back();
      bool apart = false;
      for (const auto& [x, y] : {std::pair{&a, &b}, std::pair{&b, &a}})
        for (std::size_t e = 0; e < 4; ++e) {
          const Vector3 inward = x->corners[e].cross(x->corners[(e + 1) % 4]);
          apart |=
              std::all_of(y->corners.begin(), y->corners.end(), [&](const Vector3& c) { return inward.dot(c) < 0; });
        }
      if (apart) continue;
      bounds.list.pop_back();
      break;
    }
  }
  return bounds;
}

struct Meshed {
  SphericalTriangulation triangulation;
  std::vector<Edge> section_edges;
  SectionNormals normals;
  std::set<Edge> fixed() const { return {section_edges.begin(), section_edges.end()}; }
};

Meshed hull_of(const Bounds& bounds) {
  std::vector<Vector3> corners;
  std::vector<Edge> edges;
  SectionNormals normals;
  for (std::size_t i = 0; i < bounds.list.size(); ++i) {
    const int first = static_cast<int>(4 * i);
    normals.outward.push_back(bounds.list[i].outward);
    for (int c = 0; c < 4; ++c) {
      corners.push_back(bounds.list[i].corners[static_cast<std::size_t>(c)]);
      edges.emplace_back(std::minmax(first + c, first + (c + 1) % 4));
      normals.section_of[first + c] = static_cast<int>(i);
    }
  }
  return {SphericalTriangulation(corners, Vector3::Zero()), edges, normals};
}

void expect_triangulates_the_sphere(const SphericalTriangulation& t) {
  EXPECT_EQ(t.triangles().size(), 2 * t.points().size() - 4);
  double solid_angle = 0;
  for (const auto& [a, b, c] : t.triangles()) {
    EXPECT_GT(t.orientation(a, b, c), 0);
    for (const auto& [x, y] : {Edge{a, b}, Edge{b, c}, Edge{c, a}}) EXPECT_TRUE(t.has_edge(y, x));
    const auto at = [&](int i) { return t.points()[static_cast<std::size_t>(i)].normalized(); };
    const double det = at(a).dot(at(b).cross(at(c)));
    solid_angle += 2 * std::atan2(det, 1 + at(a).dot(at(b)) + at(b).dot(at(c)) + at(c).dot(at(a)));
  }
  EXPECT_NEAR(solid_angle, 4 * M_PI, 1e-9);  // once round: no fold, no gap
}

// Sum over the edges of the angles between neighbours; a triangle that fills a section has the section's normal.
double sum_of_angles(const SphericalTriangulation& t, const SectionNormals& normals) {
  const auto normal = [&](int a, int b, int c) -> Vector3 {
    const int s = normals.section_of.at(a);
    if (s == normals.section_of.at(b) && s == normals.section_of.at(c))
      return normals.outward[static_cast<std::size_t>(s)];
    const auto at = [&](int i) { return t.points()[static_cast<std::size_t>(i)]; };
    return (at(b) - at(a)).cross(at(c) - at(a)).normalized();
  };
  double sum = 0;
  for (const auto& [a, b, c] : t.triangles())
    for (const auto& [x, y, z] : {std::array{a, b, c}, std::array{b, c, a}, std::array{c, a, b}}) {
      if (x > y) continue;
      const Vector3 n = normal(x, y, z), m = normal(y, x, t.opposite(y, x));
      sum += std::atan2(n.cross(m).norm(), n.dot(m));
    }
  return sum;
}

// How deep d lies in the circle through a, b, c on the unit sphere.
double depth_in_circle(const SphericalTriangulation& t, int a, int b, int c, int d) {
  const auto at = [&](int i) { return t.points()[static_cast<std::size_t>(i)].normalized(); };
  return (at(b) - at(a)).cross(at(c) - at(a)).normalized().dot(at(d) - at(a));
}

TEST(SphericalTriangulation, HoldsSectionEdgesAndStaysSoundThroughAllSteps) {
  Random random(1);
  int cases = 0, recovered = 0, smoothed = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    const Bounds bounds = random_bounds(random, 2 + random.below(6));
    if (visibility(bounds, Vector3::Zero()) < 1e-3) continue;
    SCOPED_TRACE("trial " + std::to_string(trial));
    ++cases;
    Meshed m = hull_of(bounds);
    SphericalTriangulation& t = m.triangulation;
    const auto all_there = [&] {
      return std::all_of(m.section_edges.begin(), m.section_edges.end(),
                         [&](const Edge& e) { return t.has_edge(e.first, e.second); });
    };
    if (!all_there()) ++recovered;
    recover_edges(t, m.section_edges);
    ASSERT_TRUE(all_there());
    make_delaunay(t, m.fixed());
    ASSERT_TRUE(all_there());
    for (const auto& [a, b, c] : t.triangles())
      for (const auto& [x, y, z] : {std::array{a, b, c}, std::array{b, c, a}, std::array{c, a, b}})
        if (!m.fixed().count(std::minmax(x, y)) && t.can_flip(x, y)) {
          EXPECT_LT(depth_in_circle(t, x, y, z, t.opposite(y, x)), 1e-8) << "a Delaunay edge has an empty circle";
        }
    const double before = sum_of_angles(t, m.normals);
    smooth_by_flips(t, m.fixed(), m.normals);
    ASSERT_TRUE(all_there());
    const double after = sum_of_angles(t, m.normals);
    EXPECT_LE(after, before + 1e-7);
    if (after < before - 1e-3) ++smoothed;
    expect_triangulates_the_sphere(t);
  }
  EXPECT_GT(cases, 500);
  EXPECT_GT(recovered, 10) << "no case needed its section edges recovered";
  EXPECT_GT(smoothed, 50);
}

// A part between random sections, and beyond each section a leaf that is one point.
Segmentation star_of(const Bounds& bounds) {
  Segmentation s;
  const auto count = static_cast<Eigen::Index>(bounds.list.size());
  s.cut.points.resize(count, 3);
  s.parts.resize(1);
  for (Eigen::Index k = 0; k < count; ++k) {
    const Bound& bound = bounds.list[static_cast<std::size_t>(k)];
    s.cut.points.row(k) = ((bound.corners[0] + bound.corners[2]) / 2 + bound.outward).transpose();
    s.parts[0].sections.push_back({static_cast<int>(k), true});
    s.parts.push_back({{{static_cast<int>(k), false}}, {static_cast<int>(k)}, false});
  }
  return s;
}

TEST(MeshCage, JoinsPartsAlsoWhereTheHullLacksTheEdgesOfTheirSections) {
  Random random(10);
  int cases = 0, lacking = 0;
  for (int trial = 0; trial < 600; ++trial) {
    const Bounds bounds = random_bounds(random, 2 + random.below(5));
    if (visibility(bounds, Vector3::Zero()) < 0.02) continue;
    SCOPED_TRACE("trial " + std::to_string(trial));
    std::vector<SectionFrame> sections;
    for (const Bound& b : bounds.list) {
      const Vector3 center = (b.corners[0] + b.corners[2]) / 2;
      sections.push_back(
          {center, b.outward, (b.corners[0] - b.corners[1]) / 2, (b.corners[1] - b.corners[2]) / 2, {1, 0}});
    }
    const Cage cage = mesh_cage(star_of(bounds), sections, std::vector<std::string>(sections.size(), "slide"));
    checks::expect_closed_manifold(cage.points, cage.triangles, 0);
    ++cases;
    std::vector<Vector3> corners;
    for (const Bound& b : bounds.list) corners.insert(corners.end(), b.corners.begin(), b.corners.end());
    const SphericalTriangulation hull(corners, cage.part_center[0]);
    bool all = true;
    for (int v = 0; v < static_cast<int>(corners.size()); ++v)
      all = all && hull.has_edge(v, v % 4 == 3 ? v - 3 : v + 1);
    lacking += !all;
  }
  EXPECT_GT(cases, 100);
  EXPECT_GT(lacking, 0);
}

TEST(SphericalTriangulation, IsTheDelaunayTriangulationOfPointsWithoutConstraints) {
  Random random(2);
  for (int trial = 0; trial < 100; ++trial) {
    std::vector<Vector3> points;
    for (int i = 0; i < 24; ++i) points.push_back(random.uniform(0.5, 2) * random.direction());
    const SphericalTriangulation t(points, Vector3::Zero());
    std::set<std::array<int, 3>> expected, found;
    for (int a = 0; a < 24; ++a)
      for (int b = a + 1; b < 24; ++b)
        for (int c = b + 1; c < 24; ++c) {
          int sides = 0;
          for (int d = 0; d < 24; ++d)
            if (d != a && d != b && d != c) sides |= depth_in_circle(t, a, b, c, d) > 0 ? 1 : 2;
          if (sides != 3) expected.insert({a, b, c});
        }
    for (std::array<int, 3> triangle : t.triangles()) {
      std::sort(triangle.begin(), triangle.end());
      found.insert(triangle);
    }
    EXPECT_EQ(found, expected);
    expect_triangulates_the_sphere(t);
  }
}

TEST(SphericalTriangulation, RecoversAnyEdgeThatPassesThroughNoPoint) {
  Random random(3);
  for (int trial = 0; trial < 300; ++trial) {
    std::vector<Vector3> points;
    for (int i = 0; i < 30; ++i) points.push_back(random.uniform(0.5, 2) * random.direction());
    SphericalTriangulation t(points, Vector3::Zero());
    const int a = random.below(30), b = (a + 1 + random.below(29)) % 30;
    if (points[static_cast<std::size_t>(a)].normalized().dot(points[static_cast<std::size_t>(b)].normalized()) < -0.9)
      continue;  // nearly opposite: no shorter arc to speak of
    recover_edges(t, {std::minmax(a, b)});
    EXPECT_TRUE(t.has_edge(a, b));
    EXPECT_TRUE(t.has_edge(b, a));
    expect_triangulates_the_sphere(t);
  }
}

TEST(SphericalTriangulation, RefusesACenterOutsideThePoints) {
  std::vector<Vector3> points;
  Random random(4);
  for (int i = 0; i < 10; ++i) points.push_back(random.direction());
  points.push_back(1.0001 * points[0]);
  for (auto& p : points) p += Vector3(3, 0, 0);
  bool sound = true;
  try {
    const SphericalTriangulation t(points, Vector3::Zero());
    for (const auto& [a, b, c] : t.triangles()) sound = sound && t.orientation(a, b, c) > 0;
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::internal);
    sound = false;
  }
  EXPECT_FALSE(sound) << "ten points on one side cannot surround the centre";
}

TEST(ConvexHull, AgreesWithTheTrianglesThatHaveAllPointsOnOneSide) {
  Random random(6);
  for (int trial = 0; trial < 50; ++trial) {
    std::vector<Vector3> points;
    for (int i = 0; i < 20; ++i)
      points.emplace_back(random.uniform(-1, 1), random.uniform(-2, 2), random.uniform(0, 1));
    const auto triangles = hull_triangles(points);
    const auto planes = hull_planes(points);
    std::size_t expected = 0;
    for (std::size_t a = 0; a < 20; ++a)
      for (std::size_t b = a + 1; b < 20; ++b)
        for (std::size_t c = b + 1; c < 20; ++c) {
          int sides = 0;
          for (const Vector3& d : points)
            sides |= std::array{1, 0, 2}[static_cast<std::size_t>(1 + orient3d(points[a], points[b], points[c], d))];
          if (sides != 3) ++expected;
        }
    EXPECT_EQ(triangles.size(), expected);
    EXPECT_EQ(planes.size(), expected);
    for (std::size_t f = 0; f < triangles.size(); ++f) {
      const auto [a, b, c] = triangles[f];
      for (int d = 0; d < 20; ++d) {
        const auto at = [&](int i) { return points[static_cast<std::size_t>(i)]; };
        EXPECT_LE(orient3d(at(a), at(b), at(c), at(d)), 0) << "counter-clockwise from outside";
        EXPECT_LE(planes[f].normal.dot(at(d)) + planes[f].offset, 1e-13);
      }
    }
  }
  EXPECT_TRUE(hull_triangles({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}).empty());
}

TEST(ConvexHull, HasOnePlaneForEachFlatFaceHoweverItIsTurned) {
  Random random(16);
  std::vector<Vector3> box;
  for (int code = 0; code < 27; ++code) box.emplace_back(code % 3, 2 * (code / 3 % 3), 3 * (code / 9));
  for (int trial = 0; trial < 20; ++trial) {
    const Eigen::Quaterniond turn =
        Eigen::Quaterniond(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1))
            .normalized();
    std::vector<Vector3> turned;
    for (const Vector3& p : box) turned.push_back(1e-3 * (turn * p));
    EXPECT_EQ(hull_planes(turned).size(), 6u);
  }
  EXPECT_TRUE(hull_planes({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0}}).empty()) << "flat";
}

// The search is local: it promises a point that will do wherever there is a fair one, not the best of all.
TEST(ProjectionCenter, IsFoundWhereverOneOfManyRandomPointsSeesAllBounds) {
  Random random(7);
  int cases = 0, as_good = 0;
  for (int trial = 0; trial < 400 && cases < 100; ++trial) {
    const Bounds bounds = random_bounds(random, 2 + random.below(4));
    double best = -1;
    for (int i = 0; i < 200; ++i)
      best = std::max(best, visibility(bounds, random.uniform(0, 1.5) * random.direction()));
    if (best < 0.02) continue;
    ++cases;
    try {
      const Vector3 center = projection_center(bounds, 0, std::vector<std::string>(bounds.list.size(), "slide"));
      EXPECT_GT(visibility(bounds, center), 0) << "trial " << trial;
      as_good += visibility(bounds, center) > 0.8 * best;
    } catch (const Error& error) {
      ADD_FAILURE() << "a random point sees all " << bounds.list.size() << " bounds: " << best << "; " << error.what();
    }
  }
  EXPECT_GE(cases, 80);
  EXPECT_GT(as_good, cases / 2);
}

TEST(ProjectionCenter, PositiveVisibilityMeansThatNoDirectionMeetsTwoBounds) {
  Random random(8);
  int positive = 0, overlapping = 0;
  for (int trial = 0; trial < 600; ++trial) {
    Bounds bounds = random_bounds(random, 2 + random.below(3));
    if (random.below(2) == 0) bounds.list.push_back(random_bound(random, static_cast<int>(bounds.list.size())));
    const Vector3 center = random.uniform(0, 0.5) * random.direction();
    const double value = visibility(bounds, center);
    bool overlaps = false;
    for (int i = 0; i < 400 && !overlaps; ++i) {
      const Vector3 d = random.direction();
      int met = 0;
      for (const Bound& bound : bounds.list) {
        bool in_cone = true;
        for (std::size_t e = 0; e < 4; ++e)
          in_cone &= (bound.corners[e] - center).cross(bound.corners[(e + 1) % 4] - center).dot(d) > 0;
        met += in_cone;
      }
      overlaps = met > 1;
    }
    overlapping += overlaps;
    if (value > 0) {
      ++positive;
      EXPECT_FALSE(overlaps) << "trial " << trial;
    }
  }
  EXPECT_GT(positive, 50);
  EXPECT_GT(overlapping, 50);
}

// Of two at one place no sphere round any centre has both.
TEST(ProjectionCenter, IsNoneWhereItSeesTwoFreeCornersInOneDirection) {
  Random random(10);
  int found = 0;
  for (int trial = 0; trial < 100; ++trial) {
    Bounds bounds = random_bounds(random, 2);
    bounds.free_corners = {3 * random.direction()};
    if (!find_projection_center(bounds)) continue;
    ++found;
    bounds.free_corners.push_back(bounds.free_corners.front());
    EXPECT_FALSE(find_projection_center(bounds)) << "trial " << trial;
  }
  EXPECT_GT(found, 10);
}

TEST(ProjectionCenter, NamesTheSlidesWhereNoPointSeesThem) {
  Bounds bounds;
  Random random(9);
  bounds.list = {random_bound(random, 0), random_bound(random, 1)};
  for (Bound& bound : bounds.list) {  // two sections in one plane, one inside the other
    const double size = bound.slide == 0 ? 1 : 0.5;
    bound.corners = {Vector3(size, size, 0), {-size, size, 0}, {-size, -size, 0}, {size, -size, 0}};
    bound.outward = Vector3::UnitZ();
  }
  const Error error = expect_error(
      [&] {
        projection_center(bounds, 4, {"wrist", "hand"});
      },
      ErrorCode::sections_overlap, {"'wrist'", "'hand'", "cut the part once more"});
  EXPECT_EQ(error.place().part, 4u);
}

}  // namespace
}  // namespace cagewright
