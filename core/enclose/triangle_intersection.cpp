// SPDX-License-Identifier: BSD-3-Clause
// Everything comes down to a segment and a triangle: two triangles meet where an edge of one meets the other.
#include "core/enclose/triangle_intersection.h"

#include <algorithm>

#include "core/mesh/predicates.h"

namespace cagewright {
namespace {

using Triangle2 = std::array<Vector2, 3>;

Vector2 without(const Vector3& p, int axis) { return {p[(axis + 1) % 3], p[(axis + 2) % 3]}; }

int orientation(const Triangle2& t) { return orient2d(t[0], t[1], t[2]); }

Triangle2 without(const Triangle3& t, int axis) {
  return {without(t[0], axis), without(t[1], axis), without(t[2], axis)};
}

bool in_box(const Vector2& p, const Vector2& a, const Vector2& b) {
  return (p.array() >= a.cwiseMin(b).array()).all() && (p.array() <= a.cwiseMax(b).array()).all();
}

bool segments_meet(const Vector2& p, const Vector2& q, const Vector2& a, const Vector2& b) {
  const int a_side = orient2d(p, q, a), b_side = orient2d(p, q, b);
  const int p_side = orient2d(a, b, p), q_side = orient2d(a, b, q);
  if (a_side * b_side < 0 && p_side * q_side < 0) return true;
  return (a_side == 0 && in_box(a, p, q)) || (b_side == 0 && in_box(b, p, q)) || (p_side == 0 && in_box(p, a, b)) ||
         (q_side == 0 && in_box(q, a, b));
}

bool is_inside(const Vector2& p, const Triangle2& t, int turn) {
  for (std::size_t i = 0; i < 3; ++i)
    if (orient2d(t[i], t[(i + 1) % 3], p) * turn < 0) return false;
  return true;
}

// All in one plane: along some axis it projects without loss.
bool coplanar_segment_meets(const Vector3& p, const Vector3& q, const Triangle3& t) {
  for (int axis = 0; axis < 3; ++axis) {
    const Triangle2 flat = without(t, axis);
    const int turn = orientation(flat);
    if (turn == 0) continue;
    const Vector2 from = without(p, axis), to = without(q, axis);
    if (is_inside(from, flat, turn) || is_inside(to, flat, turn)) return true;
    for (std::size_t i = 0; i < 3; ++i)
      if (segments_meet(from, to, flat[i], flat[(i + 1) % 3])) return true;
    return false;
  }
  return false;
}

// p_side, q_side: of the triangle's plane.
bool segment_meets(const Vector3& p, int p_side, const Vector3& q, int q_side, const Triangle3& t) {
  if (p_side * q_side > 0) return false;
  if (p_side == 0 && q_side == 0) return coplanar_segment_meets(p, q, t);
  bool left = false, right = false;  // the line passes the edges so
  for (std::size_t i = 0; i < 3; ++i) {
    const int side = orient3d(p, q, t[i], t[(i + 1) % 3]);
    left = left || side > 0;
    right = right || side < 0;
  }
  return !(left && right);
}

std::array<int, 3> sides_of(const Triangle3& s, const Triangle3& t) {
  std::array<int, 3> sides{};
  for (std::size_t i = 0; i < 3; ++i) sides[i] = orient3d(t[0], t[1], t[2], s[i]);
  return sides;
}

bool on_one_side(const std::array<int, 3>& sides) {
  return sides[0] != 0 && sides[0] == sides[1] && sides[0] == sides[2];
}

bool an_edge_meets(const Triangle3& s, const std::array<int, 3>& sides, const Triangle3& t) {
  for (std::size_t i = 0; i < 3; ++i)
    if (segment_meets(s[i], sides[i], s[(i + 1) % 3], sides[(i + 1) % 3], t)) return true;
  return false;
}

Triangle3 corners_of(const IndexedMesh& mesh, const std::array<int, 3>& vertices) {
  return {mesh.points.row(vertices[0]), mesh.points.row(vertices[1]), mesh.points.row(vertices[2])};
}

// The triangle's vertices, those that `other` has too first; their number.
std::size_t shared_first(std::array<int, 3>& vertices, const std::array<int, 3>& other) {
  const auto is_shared = [&](int v) { return std::find(other.begin(), other.end(), v) != other.end(); };
  return static_cast<std::size_t>(std::stable_partition(vertices.begin(), vertices.end(), is_shared) -
                                  vertices.begin());
}

}  // namespace

bool is_degenerate(const Triangle3& t) {
  for (int axis = 0; axis < 3; ++axis)
    if (orientation(without(t, axis)) != 0) return false;
  return true;
}

bool segment_meets_triangle(const Vector3& p, const Vector3& q, const Triangle3& t) {
  return segment_meets(p, orient3d(t[0], t[1], t[2], p), q, orient3d(t[0], t[1], t[2], q), t);
}

bool triangles_meet(const Triangle3& s, const Triangle3& t) {
  const std::array<int, 3> s_sides = sides_of(s, t);
  if (on_one_side(s_sides)) return false;
  const std::array<int, 3> t_sides = sides_of(t, s);
  return !on_one_side(t_sides) && (an_edge_meets(s, s_sides, t) || an_edge_meets(t, t_sides, s));
}

bool triangles_of_mesh_meet(const IndexedMesh& mesh, int s, int t) {
  const auto vertices_of = [&](int triangle) -> std::array<int, 3> {
    const auto row = mesh.triangles.row(triangle);
    return {row(0), row(1), row(2)};
  };
  std::array<int, 3> s_vertices = vertices_of(s), t_vertices = vertices_of(t);
  const std::size_t shared = shared_first(s_vertices, t_vertices);
  shared_first(t_vertices, s_vertices);
  const Triangle3 a = corners_of(mesh, s_vertices), b = corners_of(mesh, t_vertices);
  if (shared == 0) return triangles_meet(a, b);
  // What meets beyond a shared vertex leaves one of the two through the edge opposite to it.
  if (shared == 1) return segment_meets_triangle(a[1], a[2], b) || segment_meets_triangle(b[1], b[2], a);
  if (shared == 3) return true;
  // Beyond a shared edge only what is folded flat onto the other meets it.
  if (orient3d(a[0], a[1], a[2], b[2]) != 0) return false;
  for (int axis = 0; axis < 3; ++axis) {
    const int side = orient2d(without(a[0], axis), without(a[1], axis), without(a[2], axis));
    if (side != 0) return side == orient2d(without(a[0], axis), without(a[1], axis), without(b[2], axis));
  }
  return true;
}

}  // namespace cagewright
