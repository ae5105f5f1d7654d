// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/mesh/connectivity.h"

namespace cagewright {

// Signed volumes of the components of a mesh, against the centre of its bounding box and in cubes of `unit`, half the
// longest side of that box: so neither a huge nor a tiny model nor one far from the origin loses them.
struct Volumes {
  std::vector<double> of;  // of each component
  double total = 0;
  double rounding = 0;  // |total| at most this may be no volume at all
  double unit = 0;      // model units

  // In model units cubed; 0 or infinite where a double cannot hold it.
  double in_model_units() const { return total * unit * unit * unit; }
};

// Precondition: every vertex is used and finite. O(n).
Volumes find_volumes(const IndexedMesh& mesh, const Labels& components);

}  // namespace cagewright
