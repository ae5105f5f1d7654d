// SPDX-License-Identifier: BSD-3-Clause
#include "core/meshing/projection_center.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error/error.h"
#include "core/mesh/tolerance.h"
#include "core/meshing/convex_hull.h"

namespace cagewright {
namespace {

// How a bound is seen from a centre.
struct Cone {
  std::array<Vector3, 4> directions;  // unit, to its corners, counter-clockwise from outside
  std::array<Vector3, 4> inward;      // unit normals of the planes through the centre and its edges
};

std::array<Vector3, 4> directions_to(const Bound& bound, const Vector3& center) {
  std::array<Vector3, 4> directions;
  for (std::size_t i = 0; i < 4; ++i) directions[i] = (bound.corners[i] - center).stableNormalized();
  return directions;
}

Cone cone_of(const Bound& bound, const Vector3& center) {
  Cone cone{directions_to(bound, center), {}};
  for (std::size_t i = 0; i < 4; ++i)
    cone.inward[i] = cone.directions[i].cross(cone.directions[(i + 1) % 4]).normalized();
  return cone;
}

// The least sine over the corners of `other` beyond the planes through the centre and an edge of `cone`; the best of
// the four planes. Convex spherical polygons that do not overlap are separated by a plane through an edge of one.
double separation(const Cone& cone, const Cone& other) {
  double best = -1;
  for (const Vector3& inward : cone.inward) {
    double worst = 1;
    for (const Vector3& direction : other.directions) worst = std::min(worst, -inward.dot(direction));
    best = std::max(best, worst);
  }
  return best;
}

// The same for a single direction.
double separation(const Cone& cone, const Vector3& direction) {
  double best = -1;
  for (const Vector3& inward : cone.inward) best = std::max(best, -inward.dot(direction));
  return best;
}

double gap_between(const Cone& one, const Cone& two) { return std::max(separation(one, two), separation(two, one)); }

// The least sine at which the centre sees a corner above the bound's plane; negative from behind.
double facing(const Bound& bound, const Vector3& center) {
  double least = 1;
  for (const Vector3& direction : directions_to(bound, center)) least = std::min(least, bound.outward.dot(direction));
  return least;
}

class Visibility {
 public:
  explicit Visibility(const Bounds& bounds)
      : bounds_(bounds), corners_(bounds.corners()), hull_(hull_planes(corners_)) {}

  // The visibility of projection_center.h; where it is at most `least`, any number that is at most `least`, found
  // sooner.
  double operator()(const Vector3& center, double least = -1) const {
    if (hull_.empty()) return -1;
    double worst = inside_hull(center);
    for (std::size_t i = 0; i < bounds_.list.size() && worst > least; ++i)
      worst = std::min(worst, facing(bounds_.list[i], center));
    if (worst <= 0 || worst <= least) return worst;  // cones seen from behind have no inside
    std::vector<Cone> cones;
    for (const Bound& bound : bounds_.list) cones.push_back(cone_of(bound, center));
    for (std::size_t i = 0; i < cones.size() && worst > least; ++i)
      for (std::size_t j = i + 1; j < cones.size(); ++j) worst = std::min(worst, gap_between(cones[i], cones[j]));
    for (const Vector3& corner : bounds_.free_corners)
      for (const Cone& cone : cones) worst = std::min(worst, separation(cone, (corner - center).stableNormalized()));
    return worst;
  }

  const std::vector<HullPlane>& hull() const { return hull_; }

 private:
  // Over the distance to the farthest corner of all.
  double inside_hull(const Vector3& center) const {
    double farthest = 0;
    for (const Vector3& corner : corners_) farthest = std::max(farthest, (corner - center).norm());
    double nearest = farthest;
    for (const auto& [normal, offset] : hull_) nearest = std::min(nearest, -(normal.dot(center) + offset));
    return nearest / farthest;
  }

  const Bounds& bounds_;
  std::vector<Vector3> corners_;
  std::vector<HullPlane> hull_;
};

// Steps along the axes and space diagonals of `frame`, halved whenever none gains.
Vector3 climb(const Visibility& visibility, Vector3 point, double step, const Eigen::Matrix3d& frame) {
  const double smallest = step / 1024;
  double value = visibility(point);
  while (step > smallest) {
    Vector3 best = point;
    for (int code = 0; code < 27; ++code) {
      const int x = code % 3 - 1, y = code / 3 % 3 - 1, z = code / 9 - 1;
      const Vector3 direction(x, y, z);
      const Vector3 candidate = point + step * (frame * direction);
      const double there = visibility(candidate, value + tolerance::tie);
      if (there <= value + tolerance::tie) continue;
      value = there;
      best = candidate;
    }
    if (best == point) step /= 2;
    point = best;
  }
  return point;
}

// Climbs from points in front of each bound, for parts where the climb from the mean ended at `otherwise`, a summit
// from which it does not see them all.
Vector3 climb_from_bounds(const Visibility& visibility, const Bounds& bounds, double reach,
                          const Eigen::Matrix3d& frame, const Vector3& otherwise) {
  Vector3 best = otherwise;
  for (const double depth : {0.1, 0.3, 0.6, 1.0})
    for (const Bound& bound : bounds.list) {
      const Vector3 start = (bound.corners[0] + bound.corners[2]) / 2 - depth * reach * bound.outward;
      const Vector3 summit = climb(visibility, start, reach / 2, frame);
      if (visibility(summit) > visibility(best) + tolerance::tie) best = summit;
    }
  return best;
}

// A smooth stand-in for the least of what matters, without the angles between bounds: -log(sum exp(-b v_i)) / b. Its
// maximum is one point that moves with the model; that of the least itself is found only up to where a search stops.
class SmoothVisibility {
 public:
  SmoothVisibility(const Bounds& bounds, const std::vector<HullPlane>& hull, double reach)
      : bounds_(bounds), hull_(hull), reach_(reach) {}

  // The value, and its gradient.
  double operator()(const Vector3& center, Vector3& gradient) const {
    double sum = 0;
    gradient.setZero();
    const auto add = [&](double v, const Vector3& v_gradient) {
      const double weight = std::exp(-sharpness * v);
      sum += weight;
      gradient += weight * v_gradient;
    };
    for (const Bound& bound : bounds_.list)
      for (const Vector3& corner : bound.corners) {
        const Vector3 ray = corner - center;
        const double length = ray.norm();
        const double sine = bound.outward.dot(ray) / length;
        add(sine, (sine * ray / length - bound.outward) / length);
      }
    for (const auto& [normal, offset] : hull_) add(-(normal.dot(center) + offset) / reach_, -normal / reach_);
    gradient /= sum;
    return -std::log(sum) / sharpness;
  }

 private:
  static constexpr double sharpness = 16;
  const Bounds& bounds_;
  const std::vector<HullPlane>& hull_;
  double reach_;
};

// Newton's method with the Hessian from differences of the gradient, and steps halved until they gain. Near the maximum
// the value no longer tells one point from another, to the root of rounding, but the gradient does.
Vector3 polish(const SmoothVisibility& smooth, Vector3 point, double reach) {
  constexpr int iterations = 50, halvings = 40;
  constexpr double noise = 1e-12;
  const double difference = 1e-6 * reach, enough = 1e-14 * reach;
  Vector3 gradient, shifted;
  double value = smooth(point, gradient);
  for (int i = 0; i < iterations; ++i) {
    Eigen::Matrix3d hessian;
    for (int axis = 0; axis < 3; ++axis) {
      smooth(point + difference * Vector3::Unit(axis), shifted);
      hessian.col(axis) = (shifted - gradient) / difference;
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen((hessian + hessian.transpose()) / 2);
    const Vector3 curvature = eigen.eigenvalues().cwiseAbs().cwiseMax(1e-3 / (reach * reach));
    Vector3 step = eigen.eigenvectors() * (eigen.eigenvectors().transpose() * gradient).cwiseQuotient(curvature);
    int halving = 0;
    for (; halving < halvings && step.norm() > enough; ++halving, step /= 2) {
      const double there = smooth(point + step, shifted);
      const bool gains =
          there > value + noise || (there > value - noise && shifted.squaredNorm() < gradient.squaredNorm());
      if (!gains) continue;
      point += step;
      value = there;
      gradient = shifted;
      break;
    }
    if (halving == halvings || !(step.norm() > enough)) break;
  }
  return point;
}

std::string listed(const Bounds& bounds, const std::vector<std::string>& names) {
  std::string text;
  for (const Bound& bound : bounds.list) {
    if (bound.slide < 0) continue;
    if (!text.empty()) text += ", ";
    text += "'" + names[static_cast<std::size_t>(bound.slide)] + "'";
  }
  return text;
}

// What is most wrong with the view from `center`: a bound seen from behind, else the two that overlap most, else that
// the corners do not surround it (both -1).
struct Culprits {
  int slide = -1, other = -1;
  std::string fault = "its sections do not surround it";
};
Culprits culprits_of(const Bounds& bounds, const Vector3& center, const std::vector<std::string>& names) {
  const auto name = [&](int slide) {
    return slide < 0 ? std::string("the cap") : "'" + names[static_cast<std::size_t>(slide)] + "'";
  };
  Culprits found;
  double worst = 0;
  for (const Bound& bound : bounds.list) {
    if (facing(bound, center) > worst) continue;
    worst = facing(bound, center);
    found = {bound.slide, -1, "it sees " + name(bound.slide) + " from behind"};
  }
  if (worst < 0) return found;
  for (std::size_t i = 0; i < bounds.list.size(); ++i)
    for (std::size_t j = i + 1; j < bounds.list.size(); ++j) {
      const Bound& one = bounds.list[i];
      const Bound& two = bounds.list[j];
      const double gap = gap_between(cone_of(one, center), cone_of(two, center));
      if (gap >= worst) continue;
      worst = gap;
      found = {one.slide, two.slide, name(one.slide) + " and " + name(two.slide) + " overlap"};
    }
  if (found.slide < 0) std::swap(found.slide, found.other);
  return found;
}

// Where visibility is greatest, as far as that is found.
Vector3 best_center(const Bounds& bounds) {
  const Visibility visible(bounds);
  const Bound& first = bounds.list.front();
  Eigen::Matrix3d frame;
  frame.col(0) = (first.corners[0] - first.corners[1]).stableNormalized();
  frame.col(2) = first.outward;
  frame.col(1) = frame.col(2).cross(frame.col(0));
  double reach = 0;
  for (const Vector3& corner : bounds.corners()) reach = std::max(reach, (corner - bounds.mean()).norm());
  Vector3 center = climb(visible, bounds.mean(), reach / 2, frame);
  if (visible(center) <= tolerance::least_visibility) center = climb_from_bounds(visible, bounds, reach, frame, center);
  if (visible(center) <= tolerance::least_visibility) return center;
  const Vector3 polished = polish(SmoothVisibility(bounds, visible.hull(), reach), center, reach);
  return visible(polished) > tolerance::least_visibility ? polished : center;
}

[[noreturn]] void fail_overlapping(const Bounds& bounds, const Vector3& center, std::size_t part,
                                   const std::vector<std::string>& names) {
  const Culprits culprits = culprits_of(bounds, center, names);
  ErrorPlace place;
  place.part = part;
  place.point = center;
  if (culprits.slide >= 0) place.slide = static_cast<std::size_t>(culprits.slide);
  if (culprits.other >= 0) place.other_slide = static_cast<std::size_t>(culprits.other);
  throw Error(ErrorCode::sections_overlap,
              "no point of the part between the slides " + listed(bounds, names) +
                  " sees all its sections side by side from inside; from the best one, near " + to_text(center) + ", " +
                  culprits.fault + ": turn or move a slide there, or cut the part once more",
              place);
}

// Free corners may lie behind one another; no triangulation of a sphere has both.
bool sees_apart(const std::vector<Vector3>& corners, const Vector3& center) {
  for (std::size_t i = 0; i < corners.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const Vector3 a = (corners[i] - center).stableNormalized(), b = (corners[j] - center).stableNormalized();
      if ((a - b).norm() <= tolerance::least_visibility) return false;
    }
  return true;
}

}  // namespace

double visibility(const Bounds& bounds, const Vector3& center) { return Visibility(bounds)(center); }

std::optional<Vector3> find_projection_center(const Bounds& bounds) {
  std::optional<Vector3> center = best_center(bounds);
  const bool is_found = visibility(bounds, *center) > tolerance::least_visibility;
  if (!is_found || !sees_apart(bounds.corners(), *center)) center.reset();
  return center;
}

Vector3 projection_center(const Bounds& bounds, std::size_t part, const std::vector<std::string>& names) {
  const Vector3 center = best_center(bounds);
  if (visibility(bounds, center) > tolerance::least_visibility) return center;
  fail_overlapping(bounds, center, part, names);
}

}  // namespace cagewright
