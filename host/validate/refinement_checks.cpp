// SPDX-License-Identifier: BSD-3-Clause
#include "host/validate/refinement_checks.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace cagewright::host {
namespace {

constexpr double agreement = 1e-9;          // of lengths over the diagonal, and of directions
constexpr double weight_agreement = 1e-6;   // relative: a weight is one over a square
constexpr double smallest_distance = 1e-6;  // of the extent: bounds the weights
constexpr double tie = 2e-9;                // of the extent: (7a) and (7b) are both right so near to -delta
constexpr double convergence = 1e-3;        // (9)

struct Triangle {
  Eigen::Vector3d a, b, c;
  Eigen::Vector3d barycenter() const { return (a + b + c) / 3; }
  Eigen::Vector3d normal() const { return (b - a).cross(c - a).stableNormalized(); }
};

Triangle triangle_at(const PointList& points, const Corners& corners) {
  return {points[static_cast<std::size_t>(corners[0])], points[static_cast<std::size_t>(corners[1])],
          points[static_cast<std::size_t>(corners[2])]};
}

// The checks of one run over all iterations.
class Recomputation {
 public:
  explicit Recomputation(const ObservedCage& seen) : seen_(seen) {}

  std::vector<Check> run() {
    for (std::size_t k = 0; k < seen_.iterations.size(); ++k) {
      where_ = "iteration " + std::to_string(k);
      const ObservedIteration& iteration = seen_.iterations[k];
      start(k, iteration);
      for (std::size_t t = 0; t < seen_.triangles.size(); ++t) triangle(iteration, t);
      for (std::size_t j = 0; j < seen_.vertex_section.size(); ++j) vertex(iteration, j);
      check_outermost(seen_, iteration, where_, missed_, stray_);
      greatest(iteration);
    }
    end();
    return {start_, normals_, distances_, missed_, stray_, anchors_, weights_, damping_, planes_, end_};
  }

 private:
  std::string of_triangle(std::size_t t) const { return where_ + ", triangle " + std::to_string(t) + " of the cage: "; }
  std::string of_vertex(std::size_t j) const { return where_ + ", vertex " + std::to_string(j) + " of the cage: "; }

  void start(std::size_t k, const ObservedIteration& iteration) {
    if (k == 0) return;
    const PointList& left = seen_.iterations[k - 1].after;
    for (std::size_t j = 0; j < left.size(); ++j) {
      start_.offer((left[j] - iteration.before[j]).norm() / seen_.diagonal, [&] {
        return of_vertex(j) + "it starts from " + text_of(iteration.before[j]) +
               ", but the iteration before left it at " + text_of(left[j]);
      });
    }
  }

  void triangle(const ObservedIteration& iteration, std::size_t t) {
    const Triangle corners = triangle_at(iteration.before, seen_.triangles[t]);
    const Eigen::Vector3d& n = iteration.normals[t];
    normals_.offer((n - corners.normal()).norm(), [&] {
      return of_triangle(t) + "its corners have the normal " + text_of(corners.normal()) + ", the plug-in says " +
             text_of(n);
    });
    const bool sees_any = iteration.outermost[t] >= 0;
    const double said = iteration.signed_distances[t];
    double d = -std::numeric_limits<double>::infinity();
    if (sees_any) d = (outermost(iteration, t) - corners.barycenter()).dot(corners.normal());
    distances_.offer(d == said ? 0 : std::abs(d - said) / seen_.diagonal, [&] {
      return of_triangle(t) + "its outermost vertex has the signed distance " + text_of(d) +
             " of (6), the plug-in says " + text_of(said);
    });
    anchor(iteration, t, corners, d);
    weight(iteration, t, d);
  }

  const Eigen::Vector3d& outermost(const ObservedIteration& iteration, std::size_t t) const {
    return seen_.model[static_cast<std::size_t>(iteration.outermost[t])];
  }

  void anchor(const ObservedIteration& iteration, std::size_t t, const Triangle& corners, double d) {
    const Eigen::Vector3d keeps = corners.barycenter();                         // (7b)
    const Eigen::Vector3d moves = d > -std::numeric_limits<double>::infinity()  // (7a)
                                      ? Eigen::Vector3d(outermost(iteration, t) + seen_.delta * corners.normal())
                                      : keeps;
    const Eigen::Vector3d& said = iteration.anchors[t];
    double apart = d > -seen_.delta ? (said - moves).norm() : (said - keeps).norm();
    if (std::abs(d + seen_.delta) <= tie * seen_.extent) apart = std::min((said - moves).norm(), (said - keeps).norm());
    anchors_.offer(apart / seen_.diagonal, [&] {
      return of_triangle(t) + "(7) gives the anchor " + text_of(d > -seen_.delta ? moves : keeps) + ", the plug-in " +
             text_of(said) + ", " + text_of(apart / seen_.diagonal) + " of the diagonal apart";
    });
  }

  void weight(const ObservedIteration& iteration, std::size_t t, double d) {
    const bool may_move = d > -seen_.delta - tie * seen_.extent, may_stay = d <= -seen_.delta + tie * seen_.extent;
    for (std::size_t i = 0; i < 3; ++i) {
      const Eigen::Vector3d& u = iteration.before[static_cast<std::size_t>(seen_.triangles[t][i])];
      const double distance = std::max((u - iteration.anchors[t]).norm(), smallest_distance * seen_.extent);
      const double one = 1 / (distance * distance), said = iteration.weights[t][i];
      double off = std::numeric_limits<double>::infinity();
      if (may_move) off = std::abs(said / (seen_.push * one) - 1);
      if (may_stay) off = std::min(off, std::abs(said / one - 1));
      weights_.offer(off, [&] {
        return of_triangle(t) + "at vertex " + std::to_string(seen_.triangles[t][i]) +
               " of the cage the weight of equation (8) is " + text_of(may_move ? seen_.push * one : one) +
               ", the plug-in's " + text_of(said);
      });
    }
  }

  // mu is refine.damping times the trace of the quadratic form where the vertex may move, or ten times that as often as
  // the trust region asked for; a vertex that was stopped has no step left.
  void vertex(const ObservedIteration& iteration, std::size_t j) {
    const Eigen::Vector3d& plane = iteration.plane_normals[j];
    double trace = 0;
    for (std::size_t t = 0; t < seen_.triangles.size(); ++t) {
      for (std::size_t i = 0; i < 3; ++i) {
        if (seen_.triangles[t][i] != static_cast<int>(j)) continue;
        const double along = iteration.normals[t].dot(plane);
        trace += iteration.weights[t][i] * (iteration.normals[t].squaredNorm() - along * along);
      }
    }
    if (trace > 0) {
      const double times = iteration.damping[j] / (seen_.damping * trace);
      const double power = std::max(0.0, std::round(std::log10(times)));
      damping_.offer(times > 1e15 ? 0 : std::abs(times / std::pow(10, power) - 1), [&] {
        return of_vertex(j) + "its damping " + text_of(iteration.damping[j]) + " is " + text_of(times) +
               " times refine.damping of the trace, and no power of ten";
      });
    }
    const int section = seen_.vertex_section[j];
    Eigen::Vector3d expected = Eigen::Vector3d::Zero();
    if (seen_.is_in_plane && section >= 0) expected = seen_.sections[static_cast<std::size_t>(section)].normal;
    planes_.offer((plane - expected).norm(), [&] {
      return of_vertex(j) + "it is to move across " + text_of(expected) + " only, the plug-in says " + text_of(plane);
    });
    const double left = (iteration.after[j] - iteration.before[j]).dot(expected) / seen_.diagonal;
    planes_.offer(std::abs(left), [&] {
      return of_vertex(j) + "it leaves the plane of its slide by " + text_of(std::abs(left)) + " of the diagonal";
    });
  }

  void greatest(const ObservedIteration& iteration) {
    const auto worst = std::max_element(iteration.signed_distances.begin(), iteration.signed_distances.end());
    if (worst == iteration.signed_distances.end()) return;
    end_.offer(std::abs(*worst - iteration.max_signed_distance) / seen_.diagonal, [&] {
      return where_ + ": the largest signed distance is " + text_of(*worst) + ", the plug-in says " +
             text_of(iteration.max_signed_distance);
    });
  }

  void end() {
    const double off = std::abs(-seen_.max_signed_distance - seen_.delta) / seen_.extent - convergence;
    const bool meets = off <= 0;
    end_.offer(meets == seen_.converged || std::abs(off) < agreement ? 0 : 1, [&] {
      return "(9) is " + std::string(meets ? "met" : "not met") + " at the end, the plug-in says otherwise";
    });
    if (seen_.is_enclosed || seen_.iterations.empty()) return;
    const PointList& left = seen_.iterations.back().after;
    for (std::size_t j = 0; j < left.size(); ++j) {
      end_.offer((left[j] - seen_.vertices[j]).norm() / seen_.diagonal, [&] {
        return "vertex " + std::to_string(j) + " of the cage ends at " + text_of(seen_.vertices[j]) +
               ", but the last iteration left it at " + text_of(left[j]);
      });
    }
  }

  static Check of(const char* claim, double tolerance, const char* unit) { return {"refine", claim, tolerance, unit}; }

  const ObservedCage& seen_;
  std::string where_;
  Check start_ = of("every iteration starts where the one before ended", agreement, "of the diagonal");
  Check normals_ = of("normals are those of the triangles before the step", agreement, "of a unit vector");
  Check distances_ = of("signed distances are those of (6) at the vertices named", agreement, "of the diagonal");
  Check missed_ =
      of("no vertex that a triangle has to clear is farther out than the one named", agreement, "of the diagonal");
  Check stray_ = of("the vertices named are among those that their triangles have to clear", 1e-7, "sine");
  Check anchors_ = of("anchors are those of (7)", agreement, "of the diagonal");
  Check weights_ = of("weights are those of equation (8)", weight_agreement, "relative");
  Check damping_ = of("damping is that of the trace and the trust region", weight_agreement, "relative");
  Check planes_ =
      of("corners of sections move in their slides' planes where they are to", agreement, "of the diagonal");
  Check end_ =
      of("convergence (9) and the cage at the end are what the iterations led to", agreement, "of the diagonal");
};

}  // namespace

std::vector<Check> check_refinement(const ObservedCage& seen) { return Recomputation(seen).run(); }

}  // namespace cagewright::host
