// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "core/mesh/types.h"

namespace cagewright {

using Edge = std::pair<int, int>;

// A closed triangulation of points as seen from a centre: every triangle runs counter-clockwise as seen from outside.
// Small (tens of points): parts have few sections.
class SphericalTriangulation {
 public:
  // The spherical Delaunay triangulation of `points` round `center`: the hull of their projections.
  // Throws Error(internal) where the centre does not lie well inside the points (see visibility).
  SphericalTriangulation(std::vector<Vector3> points, const Vector3& center);

  const Vector3& center() const { return center_; }
  const std::vector<Vector3>& points() const { return points_; }
  const std::vector<std::array<int, 3>>& triangles() const { return triangles_; }

  bool has_edge(int a, int b) const { return third_.count({a, b}) > 0; }
  // The third corner of the triangle on the left of a -> b. Precondition: has_edge(a, b).
  int opposite(int a, int b) const { return third_.at({a, b}); }

  // 1 where abc runs counter-clockwise as seen from outside, exact, on the unprojected points.
  int orientation(int a, int b, int c) const;
  // Whether the two triangles at edge ab form a strictly convex quad as seen from the centre.
  bool can_flip(int a, int b) const;
  // Replaces edge ab by the one between the two opposite corners. Precondition: can_flip(a, b).
  void flip(int a, int b);

 private:
  void insert(int a, int b, int c);
  void erase(int a, int b, int c);

  std::vector<Vector3> points_;
  Vector3 center_;
  std::vector<std::array<int, 3>> triangles_;
  std::map<Edge, int> third_;  // directed edge -> opposite corner on its left
};

// Makes every edge of `constraints` an edge of the triangulation, by flips [Sloan 1993].
// Precondition: constraints do not cross each other and pass through no point. O(points^2).
void recover_edges(SphericalTriangulation& triangulation, const std::vector<Edge>& constraints);

// Restores the Delaunay property away from constraints; where four points lie on one circle, the diagonal is chosen by
// edge_rank, so that the result does not depend on rounding. O(points^2).
void make_delaunay(SphericalTriangulation& triangulation, const std::set<Edge>& constraints);

// Decides between equally good diagonals: the smaller rank wins. Corners of one section are numbered in a row, and a
// half turn of a section's numbering changes no decision.
std::pair<int, int> edge_rank(int a, int b);

}  // namespace cagewright
