// SPDX-License-Identifier: BSD-3-Clause
#include "host/validate/equation_8.h"

#include <ceres/ceres.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace cagewright::host {
namespace {

constexpr double agreement = 1e-9;  // of the diagonal

// Columns: the directions in which the vertex may move, unit and orthogonal.
Eigen::Matrix3d axes_of(const Eigen::Vector3d& plane_normal) {
  if (plane_normal.isZero()) return Eigen::Matrix3d::Identity();
  Eigen::Matrix3d axes;
  axes.col(0) = plane_normal.unitOrthogonal();
  axes.col(1) = plane_normal.cross(axes.col(0)).normalized();
  axes.col(2).setZero();
  return axes;
}

// The step s of a vertex, in its axes and over `scale`: x = u + scale axes s.
struct Step {
  Eigen::Vector3d from;
  Eigen::Matrix3d axes;
  double scale;

  template <class T>
  Eigen::Matrix<T, 3, 1> at(const T* s) const {
    return from.cast<T>() + (scale * axes).cast<T>() * Eigen::Map<const Eigen::Matrix<T, 3, 1>>(s);
  }
};

struct DistanceToPlane {
  Step step;
  Eigen::Vector3d normal, anchor;
  double root;  // of the weight

  template <class T>
  bool operator()(const T* s, T* residual) const {
    residual[0] = T(root / step.scale) * (step.at(s) - anchor.cast<T>()).dot(normal.cast<T>());
    return true;
  }
};

struct Damping {
  double root;

  template <class T>
  bool operator()(const T* s, T* residual) const {
    for (int i = 0; i < 3; ++i) residual[i] = T(root) * s[i];
    return true;
  }
};

struct Term {
  Eigen::Vector3d normal, anchor;
  double weight;
};

ceres::Solver::Options options() {
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.num_threads = 1;
  options.logging_type = ceres::SILENT;
  options.initial_trust_region_radius =
      1e16;  // linear: the first step is the whole of it, the others take off rounding
  options.max_trust_region_radius = 1e20;
  options.max_num_iterations = 4;
  options.function_tolerance = options.gradient_tolerance = options.parameter_tolerance = 0;
  return options;
}

Eigen::Vector3d minimise(const Step& step, const std::vector<Term>& terms, double mu) {
  double heaviest = mu;
  for (const Term& term : terms) heaviest = std::max(heaviest, term.weight);
  if (!(mu > 0)) return step.from;  // of no triangle with an area: nothing says where to go
  std::array<double, 3> s{};
  ceres::Problem problem;
  for (const Term& term : terms) {
    auto* cost = new DistanceToPlane{step, term.normal, term.anchor, std::sqrt(term.weight / heaviest)};
    problem.AddResidualBlock(new ceres::AutoDiffCostFunction<DistanceToPlane, 1, 3>(cost), nullptr, s.data());
  }
  problem.AddResidualBlock(new ceres::AutoDiffCostFunction<Damping, 3, 3>(new Damping{std::sqrt(mu / heaviest)}),
                           nullptr, s.data());
  ceres::Solver::Summary summary;
  ceres::Solve(options(), &problem, &summary);
  if (!summary.IsSolutionUsable()) throw std::runtime_error("Ceres on equation (8): " + summary.message);
  return step.at(s.data());
}

}  // namespace

PointList minimise_equation_8(const std::vector<Corners>& triangles, const ObservedIteration& iteration, double scale) {
  std::vector<std::vector<Term>> terms(iteration.before.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      terms[static_cast<std::size_t>(triangles[t][i])].push_back(
          {iteration.normals[t], iteration.anchors[t], iteration.weights[t][i]});
    }
  }
  PointList solution;
  for (std::size_t j = 0; j < terms.size(); ++j) {
    const Step step{iteration.before[j], axes_of(iteration.plane_normals[j]), scale};
    solution.push_back(minimise(step, terms[j], iteration.damping[j]));
  }
  return solution;
}

Check check_equation_8(const ObservedCage& seen) {
  Check check{"refine", "every vertex of every iteration is where Ceres finds the least of equation (8)", agreement,
              "of the diagonal"};
  for (std::size_t k = 0; k < seen.iterations.size(); ++k) {
    const ObservedIteration& iteration = seen.iterations[k];
    const PointList solution = minimise_equation_8(seen.triangles, iteration, seen.diagonal);
    for (std::size_t j = 0; j < solution.size(); ++j) {
      const double apart = (solution[j] - iteration.after[j]).norm() / seen.diagonal;
      check.offer(apart, [&] {
        return "iteration " + std::to_string(k) + ", vertex " + std::to_string(j) +
               " of the cage: equation (8) gives " + text_of(solution[j]) + ", the plug-in " +
               text_of(iteration.after[j]) + ", " + text_of(apart) + " of the diagonal apart";
      });
    }
  }
  return check;
}

}  // namespace cagewright::host
