// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "core/mesh/types.h"

namespace cagewright {

// What keeps a cage from enclosing its model, by exact tests. Triangles and vertices are rows of the meshes given.
struct Certificate {
  // A closed, consistently oriented 2-manifold by its vertex numbers: copies of a vertex at one place, as many files
  // have them, have to be welded before; every component of it that lies in no other has a positive volume.
  bool closed = false;
  std::vector<int> degenerate_triangles;               // of the cage: corners on a line
  std::vector<std::array<int, 2>> self_intersections;  // pairs of cage triangles, the lower first, ascending
  // Model triangles that meet the cage, ascending, each with the first cage triangle that it meets.
  std::vector<std::array<int, 2>> model_cage_intersections;
  std::vector<int> vertices_outside;  // model vertices used by a triangle and not strictly inside, ascending

  bool encloses() const {
    return closed && degenerate_triangles.empty() && self_intersections.empty() && model_cage_intersections.empty() &&
           vertices_outside.empty();
  }
};

// Certifies that `cage` bounds `model`: closed 2-manifold, consistently oriented, no two of its triangles meet but in
// what they share, none meets a model triangle (to touch is to meet), and every model vertex is inside. A vertex is
// inside where the cage winds round it a positive number of times; of a cage that is not closed the answer is that of
// the ray which is shot. Exact: predicates.h. Precondition: finite points, indices in range; the model has a volume.
// Same result for any number of threads (0: all). Thread-safe. O((n + m) log m) for what does not meet.
Certificate certify(const IndexedMesh& model, const IndexedMesh& cage, unsigned threads = 0);

}  // namespace cagewright
