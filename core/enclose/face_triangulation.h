// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "core/enclose/exact_points.h"

namespace cagewright {

// A triangulation of a triangle with further points and constrained edges in it, in the plane's projection. Exact.
// Borrows the points. Small: every insertion looks at all triangles.
class FaceTriangulation {
 public:
  // The corners run counter-clockwise in the projection.
  FaceTriangulation(const ExactPoints& points, Projection plane, const std::array<int, 3>& corners);

  // A point of the closed triangle; nothing happens where it is there already.
  void insert(int point);
  // Makes ab an edge that stays. Precondition: both are there, no point lies between them and no constraint crosses ab.
  void constrain(int a, int b);
  // Flips unconstrained edges until they are Delaunay's (in floating point).
  void improve();

  // The third corner of the triangle left of ab, -1 where there is none.
  int apex(int a, int b) const;
  bool is_constrained(int a, int b) const { return constrained_.count(std::minmax(a, b)) != 0; }
  // Counter-clockwise, each with its lowest point first, ascending.
  std::vector<std::array<int, 3>> triangles() const;

 private:
  using Edge = std::pair<int, int>;

  int orientation(int a, int b, int c) const { return points_.orientation(a, b, c, plane_); }
  void add(int a, int b, int c);
  void remove(int a, int b, int c);
  bool flip(int a, int b);
  bool should_flip(int a, int b) const;
  std::vector<Edge> find_crossed(int a, int b) const;

  const ExactPoints& points_;
  Projection plane_;
  std::map<Edge, int> apex_;  // of each directed edge
  std::set<Edge> constrained_;
  std::set<int> inserted_;
};

}  // namespace cagewright
