// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "core/enclose/box_tree.h"

namespace cagewright {

// How often a mesh winds round points, exactly: the signed number of its triangles that a ray from the point leaves
// through. Borrows mesh and tree, which is the mesh's. Thread-safe.
class Winding {
 public:
  Winding(const IndexedMesh& mesh, const BoxTree& tree);

  // Empty for a point on the mesh. Where the mesh is not closed the number depends on the ray. O(log n + triangles
  // whose boxes the ray's box meets).
  std::optional<int> of(const Vector3& point) const;

 private:
  const IndexedMesh& mesh_;
  const BoxTree& tree_;
  Box3 box_;
};

}  // namespace cagewright
