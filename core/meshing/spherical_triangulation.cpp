// SPDX-License-Identifier: BSD-3-Clause
#include "core/meshing/spherical_triangulation.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/error/error.h"
#include "core/mesh/predicates.h"
#include "core/mesh/tolerance.h"
#include "core/meshing/convex_hull.h"

namespace cagewright {

SphericalTriangulation::SphericalTriangulation(std::vector<Vector3> points, const Vector3& center)
    : points_(std::move(points)), center_(center) {
  std::vector<Vector3> projected;
  for (const Vector3& p : points_) projected.push_back((p - center_).stableNormalized());
  for (const auto& [a, b, c] : hull_triangles(projected)) insert(a, b, c);
  if (triangles_.size() + 4 != 2 * points_.size())
    throw Error(ErrorCode::internal, "meshing: the hull of the projected corners lost a corner");
}

int SphericalTriangulation::orientation(int a, int b, int c) const {
  const auto at = [&](int i) -> const Vector3& { return points_[static_cast<std::size_t>(i)]; };
  return -orient3d(at(a), at(b), at(c), center_);
}

bool SphericalTriangulation::can_flip(int a, int b) const {
  const int c = opposite(a, b), d = opposite(b, a);
  return !has_edge(c, d) && orientation(a, d, c) > 0 && orientation(d, b, c) > 0;
}

void SphericalTriangulation::flip(int a, int b) {
  const int c = opposite(a, b), d = opposite(b, a);
  erase(a, b, c);
  erase(b, a, d);
  insert(a, d, c);
  insert(d, b, c);
}

void SphericalTriangulation::insert(int a, int b, int c) {
  triangles_.push_back({a, b, c});
  third_[{a, b}] = c;
  third_[{b, c}] = a;
  third_[{c, a}] = b;
}

void SphericalTriangulation::erase(int a, int b, int c) {
  const auto same = [&](const std::array<int, 3>& t) {
    return t == std::array{a, b, c} || t == std::array{b, c, a} || t == std::array{c, a, b};
  };
  triangles_.erase(std::find_if(triangles_.begin(), triangles_.end(), same));
  third_.erase({a, b});
  third_.erase({b, c});
  third_.erase({c, a});
}

namespace {

// Whether the shorter arcs ab and cd cross in their interiors. The last test tells the crossing from its antipode.
bool cross(const SphericalTriangulation& t, int a, int b, int c, int d) {
  if (a == c || a == d || b == c || b == d) return false;
  const Vector3& o = t.center();
  const auto at = [&](int i) -> const Vector3& { return t.points()[static_cast<std::size_t>(i)]; };
  const int c_side = orient3d(o, at(a), at(b), at(c)), d_side = orient3d(o, at(a), at(b), at(d));
  const int a_side = orient3d(o, at(c), at(d), at(a)), b_side = orient3d(o, at(c), at(d), at(b));
  return c_side * d_side < 0 && a_side * b_side < 0 && c_side == b_side;
}

std::vector<Edge> edges_across(const SphericalTriangulation& t, int a, int b) {
  std::vector<Edge> crossed;
  for (const auto& triangle : t.triangles())
    for (std::size_t i = 0; i < 3; ++i) {
      const int c = triangle[i], d = triangle[(i + 1) % 3];
      if (c < d && cross(t, a, b, c, d)) crossed.emplace_back(c, d);
    }
  std::sort(crossed.begin(), crossed.end());
  return crossed;
}

// Positive where d lies inside the circle through a, b, c on the unit sphere; |value| below the second is a tie.
double in_circle(const SphericalTriangulation& t, int a, int b, int c, int d) {
  const auto at = [&](int i) -> Vector3 {
    return (t.points()[static_cast<std::size_t>(i)] - t.center()).stableNormalized();
  };
  const Vector3 normal = (at(b) - at(a)).cross(at(c) - at(a));
  return normal.dot(at(d) - at(a)) / std::max(normal.norm(), std::numeric_limits<double>::min());
}

bool prefers_other_diagonal(const SphericalTriangulation& t, int a, int b) {
  const int c = t.opposite(a, b), d = t.opposite(b, a);
  const double inside = in_circle(t, a, b, c, d);
  if (inside > tolerance::tie) return true;
  return inside >= -tolerance::tie && edge_rank(c, d) < edge_rank(a, b);
}

}  // namespace

std::pair<int, int> edge_rank(int a, int b) {
  const int first = std::min(a, b);
  return {first % 2, first};
}

void recover_edges(SphericalTriangulation& t, const std::vector<Edge>& constraints) {
  const std::size_t limit = 10 * t.points().size() * t.points().size();
  for (const auto& [a, b] : constraints) {
    for (std::size_t flips = 0; !t.has_edge(a, b); ++flips) {
      const std::vector<Edge> crossed = edges_across(t, a, b);
      // Of the crossed edges, one that no longer crosses after its flip if there is one; else any convex one.
      const Edge* chosen = nullptr;
      for (const Edge& e : crossed) {
        if (!t.can_flip(e.first, e.second)) continue;
        const int c = t.opposite(e.first, e.second), d = t.opposite(e.second, e.first);
        const bool frees = !cross(t, a, b, c, d);
        if (!chosen || frees) chosen = &e;
        if (frees) break;
      }
      if (!chosen || flips > limit) throw Error(ErrorCode::internal, "meshing: a section edge could not be recovered");
      t.flip(chosen->first, chosen->second);
    }
  }
}

void make_delaunay(SphericalTriangulation& t, const std::set<Edge>& constraints) {
  const std::size_t limit = 10 * t.points().size() * t.points().size();
  bool changed = true;
  for (std::size_t flips = 0; changed && flips < limit;) {
    changed = false;
    const auto triangles = t.triangles();
    for (const auto& triangle : triangles)
      for (std::size_t i = 0; i < 3; ++i) {
        const int a = triangle[i], b = triangle[(i + 1) % 3];
        if (a > b || !t.has_edge(a, b) || constraints.count({a, b}) || !t.can_flip(a, b)) continue;
        if (!prefers_other_diagonal(t, a, b)) continue;
        t.flip(a, b);
        ++flips;
        changed = true;
      }
  }
}

}  // namespace cagewright
