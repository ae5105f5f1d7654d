// SPDX-License-Identifier: BSD-3-Clause
// Constraints come in by flips: Sloan, A fast algorithm for generating constrained Delaunay triangulations, 1993.
#include "core/enclose/face_triangulation.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <deque>

#include "core/error/error.h"

namespace cagewright {
namespace {

constexpr double delaunay_slack = 1e-9;  // radians

double angle_at(const Vector3& corner, const Vector3& a, const Vector3& b) {
  const Vector3 to_a = a - corner, to_b = b - corner;
  return std::atan2(to_a.cross(to_b).norm(), to_a.dot(to_b));
}

}  // namespace

FaceTriangulation::FaceTriangulation(const ExactPoints& points, Projection plane, const std::array<int, 3>& corners)
    : points_(points), plane_(plane), inserted_(corners.begin(), corners.end()) {
  add(corners[0], corners[1], corners[2]);
}

void FaceTriangulation::add(int a, int b, int c) {
  apex_[{a, b}] = c;
  apex_[{b, c}] = a;
  apex_[{c, a}] = b;
}

void FaceTriangulation::remove(int a, int b, int c) {
  apex_.erase({a, b});
  apex_.erase({b, c});
  apex_.erase({c, a});
}

int FaceTriangulation::apex(int a, int b) const {
  const auto found = apex_.find({a, b});
  return found == apex_.end() ? -1 : found->second;
}

std::vector<std::array<int, 3>> FaceTriangulation::triangles() const {
  std::vector<std::array<int, 3>> all;
  for (const auto& [edge, c] : apex_)
    if (edge.first < edge.second && edge.first < c) all.push_back({edge.first, edge.second, c});
  for (const auto& [edge, c] : apex_)
    if (edge.first < c && c < edge.second) all.push_back({edge.first, edge.second, c});
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

void FaceTriangulation::insert(int p) {
  if (!inserted_.insert(p).second) return;
  for (const std::array<int, 3>& t : triangles()) {
    std::array<int, 3> sides{};
    for (std::size_t i = 0; i < 3; ++i) sides[i] = orientation(t[i], t[(i + 1) % 3], p);
    if (std::min({sides[0], sides[1], sides[2]}) < 0) continue;
    const auto on = std::find(sides.begin(), sides.end(), 0);
    if (on == sides.end()) {
      remove(t[0], t[1], t[2]);
      for (std::size_t i = 0; i < 3; ++i) add(t[i], t[(i + 1) % 3], p);
      return;
    }
    const auto i = static_cast<std::size_t>(on - sides.begin());
    const int a = t[i], b = t[(i + 1) % 3], c = t[(i + 2) % 3], d = apex(b, a);
    remove(a, b, c);
    add(p, b, c);
    add(a, p, c);
    if (d >= 0) {
      remove(b, a, d);
      add(p, a, d);
      add(b, p, d);
    }
    if (constrained_.erase(std::minmax(a, b)) > 0) {
      constrained_.insert(std::minmax(a, p));
      constrained_.insert(std::minmax(p, b));
    }
    return;
  }
  throw Error(ErrorCode::internal, "hull: a point of a face lies outside of it");
}

// Exchanges the diagonal ab of its quadrilateral, where that is strictly convex.
bool FaceTriangulation::flip(int a, int b) {
  const int c = apex(a, b), d = apex(b, a);
  if (c < 0 || d < 0 || orientation(a, d, c) <= 0 || orientation(d, b, c) <= 0) return false;
  remove(a, b, c);
  remove(b, a, d);
  add(a, d, c);
  add(d, b, c);
  return true;
}

// The edges that ab crosses, from a to b.
std::vector<FaceTriangulation::Edge> FaceTriangulation::find_crossed(int a, int b) const {
  int right = -1, left = -1;
  for (auto it = apex_.lower_bound({a, -1}); it != apex_.end() && it->first.first == a; ++it)
    if (orientation(a, b, it->first.second) < 0 && orientation(a, b, it->second) > 0) {
      right = it->first.second;
      left = it->second;
    }
  std::vector<Edge> crossed;
  while (right >= 0) {
    crossed.emplace_back(right, left);
    const int next = apex(left, right);
    if (next == b) return crossed;
    const int side = next < 0 ? 0 : orientation(a, b, next);
    if (side == 0) break;
    (side > 0 ? left : right) = next;
  }
  throw Error(ErrorCode::internal, "hull: an edge of a face is not clear");
}

void FaceTriangulation::constrain(int a, int b) {
  constrained_.insert(std::minmax(a, b));
  if (apex_.count({a, b}) != 0 || apex_.count({b, a}) != 0) return;
  const std::vector<Edge> crossed = find_crossed(a, b);
  std::deque<Edge> open(crossed.begin(), crossed.end());
  while (!open.empty()) {
    const auto [x, y] = open.front();
    open.pop_front();
    const int c = apex(x, y), d = apex(y, x);
    if (!flip(x, y)) {
      open.emplace_back(x, y);
      continue;
    }
    if (c == a || c == b || d == a || d == b) continue;
    if (orientation(a, b, c) != orientation(a, b, d)) open.emplace_back(c, d);
  }
}

bool FaceTriangulation::should_flip(int a, int b) const {
  const int c = apex(a, b), d = apex(b, a);
  if (c < 0 || d < 0 || is_constrained(a, b)) return false;
  const Vector3 &pa = points_.rounded(a), &pb = points_.rounded(b);
  const double sum = angle_at(points_.rounded(c), pa, pb) + angle_at(points_.rounded(d), pa, pb);
  return sum > 3.14159265358979323846 + delaunay_slack;
}

void FaceTriangulation::improve() {
  for (std::size_t round = 0; round < inserted_.size() + 8; ++round) {
    std::vector<Edge> edges;
    for (const auto& [edge, c] : apex_)
      if (edge.first < edge.second) edges.push_back(edge);
    bool any = false;
    for (const auto& [a, b] : edges)
      if (should_flip(a, b)) any = flip(a, b) || any;
    if (!any) return;
  }
}

}  // namespace cagewright
