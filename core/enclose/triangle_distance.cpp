// SPDX-License-Identifier: BSD-3-Clause
// Two triangles that do not meet are nearest at two of their edges, or at a corner of one and the inside of the other.
// Segments: Ericson, Real-Time Collision Detection, 5.1.9; corner and triangle: 5.1.5, the inside alone.
#include "core/enclose/triangle_distance.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace cagewright {
namespace {

double squared_distance(const Vector3& p, const Vector3& q, const Vector3& a, const Vector3& b) {
  const Vector3 u = q - p, v = b - a, w = p - a;
  const double uu = u.squaredNorm(), vv = v.squaredNorm(), uv = u.dot(v), uw = u.dot(w), vw = v.dot(w);
  double s = 0, t = 0;
  if (uu > 0 && vv > 0) {
    const double denominator = uu * vv - uv * uv;
    if (denominator > 0) s = std::clamp((uv * vw - uw * vv) / denominator, 0.0, 1.0);
    t = (uv * s + vw) / vv;
    if (t < 0 || t > 1) {
      t = std::clamp(t, 0.0, 1.0);
      s = std::clamp((uv * t - uw) / uu, 0.0, 1.0);
    }
  } else if (uu > 0) {
    s = std::clamp(-uw / uu, 0.0, 1.0);
  } else if (vv > 0) {
    t = std::clamp(vw / vv, 0.0, 1.0);
  }
  return (w + s * u - t * v).squaredNorm();
}

// Infinite where the foot of the perpendicular is not inside.
double squared_distance_to_inside(const Vector3& p, const Triangle3& t) {
  const Vector3 normal = (t[1] - t[0]).cross(t[2] - t[0]);
  for (std::size_t i = 0; i < 3; ++i)
    if (normal.cross(t[(i + 1) % 3] - t[i]).dot(p - t[i]) < 0) return std::numeric_limits<double>::infinity();
  const double length = normal.norm();
  if (!(length > 0)) return std::numeric_limits<double>::infinity();
  const double height = normal.dot(p - t[0]) / length;
  return height * height;
}

}  // namespace

double triangle_distance(const Triangle3& s, const Triangle3& t) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < 3; ++i) {
    least = std::min({least, squared_distance_to_inside(s[i], t), squared_distance_to_inside(t[i], s)});
    for (std::size_t j = 0; j < 3; ++j)
      least = std::min(least, squared_distance(s[i], s[(i + 1) % 3], t[j], t[(j + 1) % 3]));
  }
  return std::sqrt(least);
}

}  // namespace cagewright
