// SPDX-License-Identifier: BSD-3-Clause
#include "host/view/window/drawing_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <deque>
#include <numeric>
#include <random>

#include "host/view/tests/window_fixture.h"

namespace cagewright::host {
namespace {

// Vertices that a cache of 32 misses, a triangle.
double misses(const TriangleMesh& mesh) {
  std::deque<std::uint32_t> cache;
  double count = 0;
  for (const std::uint32_t vertex : mesh.triangles) {
    if (std::find(cache.begin(), cache.end(), vertex) != cache.end()) continue;
    ++count;
    cache.push_back(vertex);
    if (cache.size() > 32) cache.pop_front();
  }
  return count / static_cast<double>(mesh.triangle_count());
}

TriangleMesh shuffled(const TriangleMesh& mesh) {
  std::vector<std::size_t> rows(mesh.triangle_count());
  std::iota(rows.begin(), rows.end(), 0);
  std::shuffle(rows.begin(), rows.end(), std::mt19937(1));
  TriangleMesh result{mesh.points, {}};
  for (const std::size_t row : rows) {
    for (std::size_t k = 0; k < 3; ++k) result.triangles.push_back(mesh.triangles[3 * row + k]);
  }
  return result;
}

TEST(DrawingOrder, HasTheSameTrianglesAndSaysWhichTheyWere) {
  TriangleMesh mesh = shuffled(*sphere_mesh(20));
  mesh.points.insert(mesh.points.end(), {7, 8, 9});  // of no triangle
  const DrawingOrder order = drawing_order(mesh);
  ASSERT_EQ(order.mesh.triangle_count(), mesh.triangle_count());
  EXPECT_EQ(order.mesh.vertex_count(), mesh.vertex_count() - 1);
  ASSERT_EQ(order.triangles.size(), mesh.triangle_count());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const std::uint32_t vertex = order.mesh.triangles[i];
    const std::uint32_t there = mesh.triangles[3 * std::size_t{order.triangles[i / 3]} + i % 3];
    ASSERT_EQ(order.vertices[vertex], there);
    for (std::size_t k = 0; k < 3; ++k) {
      ASSERT_EQ(order.mesh.points[3 * std::size_t{vertex} + k], mesh.points[3 * std::size_t{there} + k]);
    }
  }
  std::vector<std::uint32_t> rows = order.triangles;
  std::sort(rows.begin(), rows.end());
  for (std::size_t i = 0; i < rows.size(); ++i) ASSERT_EQ(rows[i], i);
}

TEST(DrawingOrder, UsesVerticesAgainSoon) {
  const TriangleMesh mesh = shuffled(*sphere_mesh(60));
  EXPECT_GT(misses(mesh), 2.5);
  EXPECT_LT(misses(drawing_order(mesh).mesh), 1.1);
}

TEST(DrawingOrder, TakesMeshesWithoutExtentOrTriangles) {
  EXPECT_TRUE(drawing_order({}).mesh.points.empty());
  EXPECT_EQ(drawing_order({{1, 1, 1}, {0, 0, 0}}).mesh.triangle_count(), 1u);
  EXPECT_EQ(drawing_order({{1.7e308, 0, 0, -1.7e308, 1, 0, 0, 0, 5e-324}, {0, 1, 2}}).mesh.triangle_count(), 1u);
}

}  // namespace
}  // namespace cagewright::host
