// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/enclose/triangle_intersection.h"

namespace cagewright {

// All in floating point; degenerate triangles are allowed. O(1).

// Between two triangles that do not meet; for those that do, something between 0 and the distance of their borders.
double triangle_distance(const Triangle3& s, const Triangle3& t);

// Whether that is less than `distance`; faster where it is.
bool are_nearer_than(const Triangle3& s, const Triangle3& t, double distance);

// The points of two triangles at that distance, by barycentric coordinates.
struct NearestPoints {
  double distance = 0;
  Vector3 on_s, on_t;
};
NearestPoints nearest_points(const Triangle3& s, const Triangle3& t);

// Barycentric coordinates of the point of t that is nearest to p.
Vector3 nearest_on_triangle(const Vector3& p, const Triangle3& t);

inline Vector3 at_barycentric(const Triangle3& t, const Vector3& weights) {
  return weights[0] * t[0] + weights[1] * t[1] + weights[2] * t[2];
}

}  // namespace cagewright
