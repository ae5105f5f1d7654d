// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <vector>

#include "core/mesh/types.h"

namespace cagewright {

// A planar convex quad that bounds a part: a slide's rectangle or a cap, as the part sees it.
struct Bound {
  std::array<int, 4> vertices;  // cage vertices, counter-clockwise as seen from outside the part
  std::array<Vector3, 4> corners;
  Vector3 outward;  // unit normal, away from the part
  int slide;        // index, or -1: a cap
};

// The i-th corner of a section counter-clockwise as seen from the side that its normal points to (along_normal), or
// from the other one; corner 0 first either way.
inline int corner_as_seen(bool along_normal, int i) { return along_normal ? i : (4 - i) % 4; }

// All that bounds a part.
struct Bounds {
  std::vector<Bound> list;
  Vector3 mean() const {
    Vector3 sum = Vector3::Zero();
    for (const Bound& bound : list)
      for (const Vector3& corner : bound.corners) sum += corner;
    return sum / static_cast<double>(4 * list.size());
  }
};

}  // namespace cagewright
