// SPDX-License-Identifier: BSD-3-Clause
// Two triangles that do not meet are nearest at two of their edges, or at a corner of one and the inside of the other.
// Segments: Ericson, Real-Time Collision Detection, 5.1.9; corner and triangle: 5.1.5.
#include "core/enclose/triangle_distance.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include "core/mesh/tolerance.h"

namespace cagewright {
namespace {

// Shares of the way along pq and ab at which they are nearest.
std::pair<double, double> nearest_of_segments(const Vector3& p, const Vector3& q, const Vector3& a, const Vector3& b) {
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
  return {s, t};
}

// Calls `visit(squared distance, weights)`, where weights() gives both points by barycentric coordinates, with every
// pair of points that may be the nearest, until it returns true; whether it did.
template <class Visit>
bool visit_candidates(const Triangle3& s, const Triangle3& t, const Visit& visit) {
  Vector3 foot;
  const auto of_s = [&](std::size_t i) { return [&foot, i] { return std::pair(on_edge(i, 0), foot); }; };
  const auto of_t = [&](std::size_t i) { return [&foot, i] { return std::pair(foot, on_edge(i, 0)); }; };
  for (std::size_t i = 0; i < 3; ++i) {
    if (foot_inside(s[i], t, foot) && visit((at_barycentric(t, foot) - s[i]).squaredNorm(), of_s(i))) return true;
    if (foot_inside(t[i], s, foot) && visit((at_barycentric(s, foot) - t[i]).squaredNorm(), of_t(i))) return true;
    const Vector3& p = s[i];
    const Vector3& q = s[(i + 1) % 3];
    for (std::size_t j = 0; j < 3; ++j) {
      const Vector3& a = t[j];
      const Vector3& b = t[(j + 1) % 3];
      const auto [along_s, along_t] = nearest_of_segments(p, q, a, b);
      const auto weights = [i, j, s_share = along_s, t_share = along_t] {
        return std::pair(on_edge(i, s_share), on_edge(j, t_share));
      };
      if (visit((p + along_s * (q - p) - a - along_t * (b - a)).squaredNorm(), weights)) return true;
    }
  }
  return false;
}

}  // namespace

Vector3 unit_normal(const Triangle3& t) { return (t[1] - t[0]).cross(t[2] - t[0]).stableNormalized(); }

// Not less than: NaN is thin.
bool is_thin(const Triangle3& t, const Eigen::AlignedBox3d& box) {
  return !((t[1] - t[0]).cross(t[2] - t[0]).norm() > tolerance::thin_triangle * box.sizes().squaredNorm());
}

bool plane_parts(const Triangle3& t, const Vector3& n, const Triangle3& other, double distance) {
  const double a = n.dot(other[0] - t[0]), b = n.dot(other[1] - t[0]), c = n.dot(other[2] - t[0]);
  return std::min({a, b, c}) > distance || std::max({a, b, c}) < -distance;
}

Capsule::Capsule(const Triangle3& t) {
  std::size_t longest = 0;
  double squared = -1;
  for (std::size_t i = 0; i < 3; ++i)
    if (const double length = (t[(i + 1) % 3] - t[i]).squaredNorm(); length > squared) {
      squared = length;
      longest = i;
    }
  begin_ = t[longest];
  along_ = t[(longest + 1) % 3] - begin_;
  const Vector3& apex = t[(longest + 2) % 3];
  const double share = squared > 0 ? std::clamp(along_.dot(apex - begin_) / squared, 0.0, 1.0) : 0;
  radius_ = (begin_ + share * along_ - apex).norm();
}

bool Capsule::parts_ball(const Vector3& center, double radius, double distance) const {
  const double squared = along_.squaredNorm();
  const double share = squared > 0 ? std::clamp(along_.dot(center - begin_) / squared, 0.0, 1.0) : 0;
  const double size = begin_.cwiseAbs().maxCoeff() + center.cwiseAbs().maxCoeff();
  return (begin_ + share * along_ - center).norm() > radius_ + radius + distance + tolerance::rounding * size;
}

Prism::Prism(const Triangle3& t, const Eigen::AlignedBox3d& box) : is_thin_(is_thin(t, box)), normal_(unit_normal(t)) {
  if (is_thin_) {
    capsule_ = Capsule(t);
    return;
  }
  offset_ = normal_.dot(t[0]);
  for (std::size_t i = 0; i < 3; ++i) {
    sides_[i] = (t[(i + 1) % 3] - t[i]).cross(normal_).stableNormalized();
    side_offsets_[i] = sides_[i].dot(t[i]);
  }
}

bool Prism::parts_ball(const Vector3& center, double distance) const {
  if (is_thin_) return capsule_.parts_ball(center, 0, distance);
  if (std::abs(normal_.dot(center) - offset_) > distance) return true;
  for (std::size_t i = 0; i < 3; ++i)
    if (sides_[i].dot(center) - side_offsets_[i] > distance) return true;
  return false;
}

bool Prism::parts(const Triangle3& other, double distance) const {
  if (is_thin_) {
    const Vector3 center = (other[0] + other[1] + other[2]) / 3;
    const double radius =
        std::max({(other[0] - center).norm(), (other[1] - center).norm(), (other[2] - center).norm()});
    return capsule_.parts_ball(center, radius, distance);
  }
  const double a = normal_.dot(other[0]) - offset_, b = normal_.dot(other[1]) - offset_,
               c = normal_.dot(other[2]) - offset_;
  if (std::min({a, b, c}) > distance || std::max({a, b, c}) < -distance) return true;
  for (std::size_t i = 0; i < 3; ++i) {
    const double least = std::min({sides_[i].dot(other[0]), sides_[i].dot(other[1]), sides_[i].dot(other[2])});
    if (least - side_offsets_[i] > distance) return true;
  }
  return false;
}

NearestPoints nearest_points(const Triangle3& s, const Triangle3& t) {
  double least = std::numeric_limits<double>::infinity();
  NearestPoints best;
  visit_candidates(s, t, [&](double squared, const auto& weights) {
    if (squared >= least) return false;
    least = squared;
    std::tie(best.on_s, best.on_t) = weights();
    return false;
  });
  best.distance = std::sqrt(least);
  return best;
}

double triangle_distance(const Triangle3& s, const Triangle3& t) { return nearest_points(s, t).distance; }

bool are_nearer_than(const Triangle3& s, const Triangle3& t, double distance) {
  return visit_candidates(s, t, [&](double squared, const auto&) { return std::sqrt(squared) < distance; });
}

}  // namespace cagewright
