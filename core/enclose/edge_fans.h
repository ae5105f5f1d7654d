// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/enclose/arrangement.h"

namespace cagewright {

// A face at an edge that runs from its lower to its higher point.
struct FanFace {
  int face = 0;
  int edge = 0;          // of the face
  bool is_left = false;  // the face, as its source runs, goes along the edge from the lower to the higher point
  // The faces of one angle follow each other, and have one number.
  int angle = 0;
};

// The faces at each edge that is constrained, counter-clockwise round it. Exact; in a fixed order.
std::vector<std::vector<FanFace>> find_edge_fans(const IndexedMesh& mesh, const Arrangement& arrangement);

}  // namespace cagewright
