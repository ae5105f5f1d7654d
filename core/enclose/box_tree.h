// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <functional>
#include <memory>
#include <vector>

#include "core/enclose/triangle_intersection.h"
#include "core/mesh/types.h"

namespace cagewright {

using Box3 = Eigen::AlignedBox3d;

Box3 box_of_triangle(const IndexedMesh& mesh, Eigen::Index triangle);

// The triangles of a mesh in a tree of boxes. Immutable, so safe to share between threads; keeps nothing of the mesh.
class BoxTree {
 public:
  // O(n log n).
  explicit BoxTree(const IndexedMesh& mesh);
  ~BoxTree();
  BoxTree(BoxTree&&) noexcept;
  BoxTree& operator=(BoxTree&&) noexcept;

  // Calls `visit` with the triangles whose boxes meet `box` until it returns true. In no order that means anything.
  void visit(const Box3& box, const std::function<bool(int triangle)>& visit) const;
  // The same with the triangles whose boxes come within `distance` (>= 0) of the box of `t` and, but for rounding, of
  // its plane: all that are within that distance of t, and few others.
  void visit_near(const Triangle3& t, double distance, const std::function<bool(int triangle)>& visit) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

}  // namespace cagewright
