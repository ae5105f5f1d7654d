// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "core/enclose/arrangement.h"
#include "core/enclose/triangle_intersection.h"

namespace cagewright {

// What other triangles leave in a triangle: points, and segments (by point number, the lower first).
struct Traces {
  std::set<int> points;
  std::set<std::pair<int, int>> segments;
};

// Finds where the triangles of a mesh meet. Borrows the mesh; adds to the arrangement's points.
class TriangleMeetings {
 public:
  // Needs the arrangement's corners and planes.
  TriangleMeetings(const IndexedMesh& mesh, Arrangement& arrangement);

  // Of each triangle the traces of all others.
  std::vector<Traces> find();

 private:
  using Sides = std::array<int, 3>;

  bool is_flat(int s) const { return arrangement_.corners[index(s)][0] == arrangement_.corners[index(s)][1]; }
  static std::size_t index(int k) { return static_cast<std::size_t>(k); }
  Sides sides(int s, int t) const;
  bool contains(int t, int point) const;
  void meet(int s, int t);
  void add_meets(int s, const Sides& sides, int t, std::vector<int>& found);
  void add_coplanar(int s, int t);

  const IndexedMesh& mesh_;
  Arrangement& arrangement_;
  std::vector<Traces> traces_;
  std::map<std::array<int, 3>, int> crossings_;  // of an edge with a triangle's plane: lower, upper point, triangle
};

}  // namespace cagewright
