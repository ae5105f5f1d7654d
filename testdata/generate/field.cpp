// SPDX-License-Identifier: BSD-3-Clause
#include "testdata/generate/field.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace cagewright::testdata {
namespace {

constexpr int kConesPerSpan = 6;

// Polynomial smooth minimum: differs from min(a, b) only where |a - b| < blend, and never by more than blend / 4.
double smooth_minimum(double a, double b, double blend) {
  if (blend <= 0) return std::min(a, b);
  const double overlap = std::max(blend - std::abs(a - b), 0.0) / blend;
  return std::min(a, b) - overlap * overlap * blend / 4;
}

// A value in the span from `b` to `c` of the Catmull-Rom curve through a, b, c, d.
template <typename T>
T catmull_rom(const T& a, const T& b, const T& c, const T& d, double t) {
  const double t2 = t * t;
  const double t3 = t2 * t;
  return T(0.5 * (2 * b + t * (c - a) + t2 * (2 * a - 5 * b + 4 * c - d) + t3 * (3 * b - a - 3 * c + d)));
}

std::vector<Knot> refine(const std::vector<Knot>& knots) {
  std::vector<Knot> fine;
  const auto last = knots.size() - 1;
  for (std::size_t span = 0; span < last; ++span) {
    const Knot& a = knots[span == 0 ? 0 : span - 1];
    const Knot& b = knots[span];
    const Knot& c = knots[span + 1];
    const Knot& d = knots[std::min(span + 2, last)];
    for (int step = 0; step < kConesPerSpan; ++step) {
      const double t = static_cast<double>(step) / kConesPerSpan;
      fine.push_back(
          {catmull_rom(a.point, b.point, c.point, d.point, t), catmull_rom(a.radius, b.radius, c.radius, d.radius, t)});
    }
  }
  fine.push_back(knots.back());
  return fine;
}

}  // namespace

void Field::add_limb(const std::vector<Knot>& knots, double blend) {
  if (knots.size() < 2) throw std::invalid_argument("a limb needs at least 2 knots");
  Piece piece;
  piece.blend = blend;
  const std::vector<Knot> fine = refine(knots);
  for (std::size_t i = 0; i + 1 < fine.size(); ++i) {
    const Eigen::Vector3d axis = fine[i + 1].point - fine[i].point;
    const double length = axis.norm();
    const double loss = fine[i].radius - fine[i + 1].radius;
    if (length <= std::abs(loss)) throw std::invalid_argument("a limb's knots are closer than their radii differ");
    piece.cones.push_back({fine[i].point, axis / length, length, fine[i].radius, loss / length});
  }
  for (const Knot& knot : fine) {
    piece.box.extend(Eigen::Vector3d(knot.point.array() - knot.radius));
    piece.box.extend(Eigen::Vector3d(knot.point.array() + knot.radius));
  }
  piece.center = piece.box.center();
  for (const Knot& knot : fine) piece.radius = std::max(piece.radius, (knot.point - piece.center).norm() + knot.radius);
  pieces_.push_back(std::move(piece));
}

void Field::add_ellipsoid(const Eigen::Vector3d& center, const Eigen::Vector3d& radii, double blend,
                          const Eigen::Matrix3d& axes) {
  Piece piece;
  piece.blend = blend;
  piece.ellipsoids.push_back({center, radii, axes.transpose()});
  piece.center = center;
  piece.radius = radii.maxCoeff();
  piece.box.extend(Eigen::Vector3d(center.array() - piece.radius));
  piece.box.extend(Eigen::Vector3d(center.array() + piece.radius));
  pieces_.push_back(std::move(piece));
}

// Of the spheres that sweep out the cone, the one that touches the surface nearest to p is met along the normal of the
// slanted side: its centre lies `across * slope / cosine` before the foot of p on the axis.
double Field::distance(const RoundCone& cone, const Eigen::Vector3d& p) {
  const Eigen::Vector3d offset = p - cone.start;
  const double along = offset.dot(cone.direction);
  const double across = std::sqrt(std::max(offset.squaredNorm() - along * along, 0.0));
  const double cosine = std::sqrt(1 - cone.slope * cone.slope);
  const double foot = std::clamp(along - across * cone.slope / cosine, 0.0, cone.length);
  const double gap = along - foot;
  return std::sqrt(across * across + gap * gap) - (cone.start_radius - cone.slope * foot);
}

// First-order distance: (|p / r|^2 - 1) over the length of its gradient, in a form that is right near the surface.
double Field::distance(const Ellipsoid& ellipsoid, const Eigen::Vector3d& p) {
  const Eigen::Vector3d scaled = (ellipsoid.to_local * (p - ellipsoid.center)).cwiseQuotient(ellipsoid.radii);
  const double level = scaled.norm();
  const double slope = scaled.cwiseQuotient(ellipsoid.radii).norm();
  if (slope <= 0) return -ellipsoid.radii.minCoeff();
  return level * (level - 1) / slope;
}

double Field::distance(const Piece& piece, const Eigen::Vector3d& p) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const RoundCone& cone : piece.cones) nearest = std::min(nearest, distance(cone, p));
  for (const Ellipsoid& ellipsoid : piece.ellipsoids) nearest = std::min(nearest, distance(ellipsoid, p));
  return nearest;
}

double Field::value(const Eigen::Vector3d& p) const {
  double sum = std::numeric_limits<double>::infinity();
  for (const Piece& piece : pieces_) {
    // A limb further off than its blend cannot change the sum. Ellipsoids give no such bound.
    const bool bounded = piece.ellipsoids.empty();
    if (bounded && (p - piece.center).norm() - piece.radius >= sum + piece.blend) continue;
    const double next = distance(piece, p);
    sum = std::isinf(sum) ? next : smooth_minimum(sum, next, piece.blend);
  }
  return sum;
}

Eigen::Vector3d Field::gradient(const Eigen::Vector3d& p) const {
  constexpr double kStep = 1e-6;
  Eigen::Vector3d result;
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::Vector3d step = kStep * Eigen::Vector3d::Unit(axis);
    result[axis] = (value(p + step) - value(p - step)) / (2 * kStep);
  }
  return result;
}

Eigen::AlignedBox3d Field::bounds() const {
  Eigen::AlignedBox3d box;
  double blend = 0;
  for (const Piece& piece : pieces_) {
    box.extend(piece.box);
    blend = std::max(blend, piece.blend);
  }
  // Each smooth union swells by at most a quarter of its blend; unions of three or more at one place are rare.
  return {Eigen::Vector3d(box.min().array() - blend), Eigen::Vector3d(box.max().array() + blend)};
}

Eigen::Matrix3d facing(const Eigen::Vector3d& forward, const Eigen::Vector3d& up) {
  Eigen::Matrix3d axes;
  axes.col(2) = forward.normalized();
  axes.col(0) = up.cross(axes.col(2)).normalized();
  axes.col(1) = axes.col(2).cross(axes.col(0));
  return axes;
}

}  // namespace cagewright::testdata
