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
  std::vector<Vector3> free_corners;  // of its limb caps: the cage has vertices there, their edges are any
  std::vector<Vector3> corners() const {
    std::vector<Vector3> all;
    for (const Bound& bound : list) all.insert(all.end(), bound.corners.begin(), bound.corners.end());
    all.insert(all.end(), free_corners.begin(), free_corners.end());
    return all;
  }
  Vector3 mean() const {
    Vector3 sum = Vector3::Zero();
    const std::vector<Vector3> all = corners();
    for (const Vector3& corner : all) sum += corner;
    return sum / static_cast<double>(all.size());
  }
};

}  // namespace cagewright
