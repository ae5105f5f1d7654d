// SPDX-License-Identifier: BSD-3-Clause
// Ericson, Real-Time Collision Detection, 5.1.5.
#include "core/mesh/triangle.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

namespace cagewright {

Vector3 nearest_on_triangle(const Vector3& p, const Triangle3& t) {
  Vector3 weights;
  if (foot_inside(p, t, weights)) return weights;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector3 along = t[(i + 1) % 3] - t[i];
    const double squared = along.squaredNorm();
    const double share = squared > 0 ? std::clamp(along.dot(p - t[i]) / squared, 0.0, 1.0) : 0;
    const double distance = (t[i] + share * along - p).squaredNorm();
    if (distance >= least) continue;
    least = distance;
    weights = on_edge(i, share);
  }
  return weights;
}

}  // namespace cagewright
