// SPDX-License-Identifier: BSD-3-Clause
#include "core/enclose/triangle_meetings.h"

#include <algorithm>

#include "core/enclose/box_tree.h"
#include "core/mesh/predicates.h"

namespace cagewright {

TriangleMeetings::TriangleMeetings(const IndexedMesh& mesh, Arrangement& arrangement)
    : mesh_(mesh), arrangement_(arrangement), traces_(static_cast<std::size_t>(mesh.triangles.rows())) {}

std::vector<Traces> TriangleMeetings::find() {
  const BoxTree tree(mesh_);
  for (int s = 0; s < static_cast<int>(mesh_.triangles.rows()); ++s) {
    if (is_flat(s)) continue;
    std::vector<int> others;
    tree.visit(box_of_triangle(mesh_, s), [&](int t) {
      if (t > s && !is_flat(t)) others.push_back(t);
      return false;
    });
    std::sort(others.begin(), others.end());
    for (const int t : others) meet(s, t);
  }
  return std::move(traces_);
}

// Of the corners of s against the plane of t.
TriangleMeetings::Sides TriangleMeetings::sides(int s, int t) const {
  const Triangle3 corners = triangle_of(mesh_, s), plane = triangle_of(mesh_, t);
  Sides found{};
  for (std::size_t i = 0; i < 3; ++i)
    found[i] = arrangement_.corners[index(s)][i] == arrangement_.corners[index(t)][i]
                   ? 0
                   : orient3d(plane[0], plane[1], plane[2], corners[i]);
  return found;
}

// Of a point in the plane of t.
bool TriangleMeetings::contains(int t, int point) const {
  const auto& c = arrangement_.corners[index(t)];
  for (std::size_t i = 0; i < 3; ++i)
    if (arrangement_.points.orientation(c[i], c[(i + 1) % 3], point, arrangement_.planes[index(t)]) < 0) return false;
  return true;
}

void TriangleMeetings::meet(int s, int t) {
  const Sides of_s = sides(s, t);
  if (of_s[0] != 0 && of_s[0] == of_s[1] && of_s[0] == of_s[2]) return;
  if (of_s == Sides{0, 0, 0}) {
    add_coplanar(s, t);
    add_coplanar(t, s);
    return;
  }
  const Sides of_t = sides(t, s);
  if (of_t[0] != 0 && of_t[0] == of_t[1] && of_t[0] == of_t[2]) return;
  std::vector<int> found;
  add_meets(s, of_s, t, found);
  add_meets(t, of_t, s, found);
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  for (const int triangle : {s, t}) {
    traces_[index(triangle)].points.insert(found.begin(), found.end());
    if (found.size() == 2) traces_[index(triangle)].segments.emplace(found[0], found[1]);
  }
}

// Where corners and edges of s meet t. An edge in the plane of t is told by its ends and by the edges of t.
void TriangleMeetings::add_meets(int s, const Sides& sides, int t, std::vector<int>& found) {
  const auto &corners = arrangement_.corners[index(s)], &plane = arrangement_.corners[index(t)];
  const Triangle3 wall = triangle_of(mesh_, t), at = triangle_of(mesh_, s);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    if (sides[i] == 0 && contains(t, corners[i])) found.push_back(corners[i]);
    if (sides[i] * sides[j] >= 0) continue;
    bool left = false, right = false;  // the line passes the edges of t so
    for (std::size_t k = 0; k < 3; ++k) {
      const int side = orient3d(at[i], at[j], wall[k], wall[(k + 1) % 3]);
      left = left || side > 0;
      right = right || side < 0;
    }
    if (left && right) continue;
    const auto [low, high] = std::minmax(corners[i], corners[j]);
    const auto [place, is_new] = crossings_.try_emplace({low, high, t}, -1);
    if (is_new) place->second = arrangement_.points.meet_plane(low, high, plane);
    found.push_back(place->second);
  }
}

// What the edges of s leave in t, which is in the same plane.
void TriangleMeetings::add_coplanar(int s, int t) {
  const auto &from = arrangement_.corners[index(s)], &to = arrangement_.corners[index(t)];
  const Projection plane = arrangement_.planes[index(t)];
  ExactPoints& points = arrangement_.points;
  Traces& traces = traces_[index(t)];
  for (std::size_t i = 0; i < 3; ++i) {
    const int a = from[i], b = from[(i + 1) % 3];
    std::vector<int> on;
    for (const int end : {a, b})
      if (contains(t, end)) on.push_back(end);
    for (std::size_t k = 0; k < 3; ++k) {
      const int c = to[k], d = to[(k + 1) % 3];
      const int of_c = points.orientation(a, b, c, plane), of_d = points.orientation(a, b, d, plane);
      if (of_c == 0 && points.is_between(c, a, b)) on.push_back(c);
      if (of_c * of_d < 0 && points.orientation(c, d, a, plane) * points.orientation(c, d, b, plane) < 0)
        on.push_back(points.meet_line(a, b, c, d, plane));
    }
    if (on.empty()) continue;
    traces.points.insert(on.begin(), on.end());
    const auto along = [&](int p, int q) {
      for (int axis = 0; axis < 3; ++axis)
        if (const int side = points.compare(p, q, axis); side != 0) return side < 0;
      return false;
    };
    const auto [low, high] = std::minmax_element(on.begin(), on.end(), along);
    if (*low != *high) traces.segments.insert(std::minmax(*low, *high));
  }
}

}  // namespace cagewright
