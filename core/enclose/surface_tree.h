// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/enclose/triangle_intersection.h"
#include "core/mesh/types.h"

namespace cagewright {

// The triangles of a mesh in a tree of boxes, for distances to them. Immutable, so safe to share between threads; keeps
// nothing of the mesh. Floating point. Same answers for any number of threads that made it.
class SurfaceTree {
 public:
  // Precondition: finite points, indices in range, at least one triangle; degenerate ones are allowed. O(n log n).
  explicit SurfaceTree(const IndexedMesh& mesh, unsigned threads = 0);

  struct Nearest {
    double distance;  // model units
    int place;        // of the nearest triangle in this tree, good as a hint; not its row in the mesh
  };
  // From a point to the surface. `hint` is the place of a triangle that may be near, such as that of a point next to
  // this one; it saves time. O(log n) where boxes are small beside the distance.
  Nearest nearest(const Vector3& point, int hint = 0) const;

  // From a triangle to the surface, or `bound` where nothing is nearer than that. Precondition: the triangle does not
  // meet the surface.
  double distance(const Triangle3& triangle, double bound) const;

 private:
  struct Box {
    Vector3 min, max;
  };
  template <class Query>
  void visit(std::size_t level, std::size_t index, Query& query) const;

  std::vector<Triangle3> triangles_;      // along a curve that fills space
  std::vector<std::vector<Box>> levels_;  // of boxes, the last of one box; each holds `fan` of the level below
};

}  // namespace cagewright
