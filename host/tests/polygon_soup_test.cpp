// SPDX-License-Identifier: BSD-3-Clause
#include "host/file/polygon_soup.h"

#include <cmath>
#include <map>
#include <numeric>
#include <random>

#include "host/tests/expect_file_error.h"
#include "host/tests/sample_meshes.h"

namespace cagewright::host {
namespace {

using Edge = std::pair<std::uint32_t, std::uint32_t>;

std::vector<std::uint32_t> fill(const std::vector<double>& points) {
  std::vector<std::uint32_t> corners(points.size() / 3), triangles;
  std::iota(corners.begin(), corners.end(), 0u);
  append_polygon(points, corners, triangles);
  return triangles;
}

double area(const std::vector<double>& points, const std::vector<std::uint32_t>& triangles, std::size_t t) {
  const double* a = &points[3 * std::size_t{triangles[3 * t]}];
  const double* b = &points[3 * std::size_t{triangles[3 * t + 1]}];
  const double* c = &points[3 * std::size_t{triangles[3 * t + 2]}];
  return ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2;
}

// The edges that no other triangle runs in the opposite direction.
std::vector<Edge> border(const std::vector<std::uint32_t>& triangles) {
  std::map<Edge, int> count;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const std::uint32_t a = triangles[i], b = triangles[i % 3 == 2 ? i - 2 : i + 1];
    ++count[{a, b}];
    --count[{b, a}];
  }
  std::vector<Edge> result;
  for (const auto& [edge, times] : count) {
    if (times > 0) result.push_back(edge);
  }
  return result;
}

// A polygon around the origin whose corners lie in directions of their own, near and far: rarely convex.
std::vector<double> star(std::mt19937& random, std::size_t corners) {
  std::vector<double> points;
  for (std::size_t i = 0; i < corners; ++i) {
    const double angle = 2 * std::acos(-1.0) * static_cast<double>(i) / static_cast<double>(corners);
    const double radius = std::uniform_real_distribution<double>(0.2, 1)(random);
    points.insert(points.end(), {radius * std::cos(angle), radius * std::sin(angle), 0.0});
  }
  return points;
}

TEST(PolygonSoup, FansConvexPolygons) {
  EXPECT_EQ(fill({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}), (Rows{0, 1, 2, 0, 2, 3}));
}

TEST(PolygonSoup, CutsAQuadWithADentFromTheDent) {
  const std::vector<double> dart = {0, 0, 0, 4, -4, 0, 1, 0, 0, 4, 4, 0};
  const std::vector<std::uint32_t> triangles = fill(dart);
  ASSERT_EQ(triangles.size(), 6u);
  EXPECT_GT(area(dart, triangles, 0), 0);
  EXPECT_GT(area(dart, triangles, 1), 0);
}

TEST(PolygonSoup, FillsAnySimplePolygonOnceWithItsEdgesAsBorder) {
  std::mt19937 random(1);
  for (int trial = 0; trial < 300; ++trial) {
    const std::vector<double> points = star(random, 4 + random() % 30);
    const std::vector<std::uint32_t> triangles = fill(points);
    const std::size_t corners = points.size() / 3;
    ASSERT_EQ(triangles.size(), 3 * (corners - 2));
    for (std::size_t t = 0; t < corners - 2; ++t) EXPECT_GT(area(points, triangles, t), 0);
    EXPECT_EQ(border(triangles).size(), corners);
    for (const auto& [a, b] : border(triangles)) EXPECT_EQ(b, (a + 1) % corners);
  }
}

TEST(PolygonSoup, KeepsTheBorderOfPolygonsThatCrossThemselvesOrHaveNoArea) {
  for (const std::vector<double>& points : {std::vector<double>{0, 0, 0, 1, 1, 0, 1, 0, 0, 0, 1, 0},
                                            std::vector<double>{0, 0, 0, 1, 0, 0, 2, 0, 0, 3, 0, 0, 4, 0, 0}}) {
    EXPECT_EQ(border(fill(points)).size(), points.size() / 3);
  }
}

TEST(PolygonSoup, KeepsTheOrderOfFacesWithDifferentNumbersOfCorners) {
  PolygonSoup soup{{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}, {0, 1, 2, 0, 1, 2, 3, 3, 2, 1}, {3, 7, 10}};
  EXPECT_EQ(triangulate(soup, "a.obj").triangles, (Rows{0, 1, 2, 0, 1, 2, 0, 2, 3, 3, 2, 1}));
}

}  // namespace
}  // namespace cagewright::host
