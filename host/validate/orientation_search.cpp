// SPDX-License-Identifier: BSD-3-Clause
#include "host/validate/orientation_search.h"

#include <ceres/ceres.h>

#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>

namespace cagewright::host {
namespace {

struct PullVector {
  Eigen::Vector2d target;
  double root;

  template <class T>
  bool operator()(const T* x, T* residual) const {
    for (int i = 0; i < 2; ++i) residual[i] = T(root) * (x[i] - T(target[i]));
    return true;
  }
};

struct TieVectors {
  Eigen::Matrix2d turn;
  double root;

  template <class T>
  bool operator()(const T* x_k, const T* x_h, T* residual) const {
    for (int i = 0; i < 2; ++i) residual[i] = T(root) * (T(turn(i, 0)) * x_k[0] + T(turn(i, 1)) * x_k[1] - x_h[i]);
    return true;
  }
};

template <class T>
std::array<T, 2> fourth_power(const T& angle) {
  using std::cos;
  using std::sin;
  return {cos(T(4) * angle), sin(T(4) * angle)};
}

struct PullAngle {
  PullVector vector;

  template <class T>
  bool operator()(const T* angle, T* residual) const {
    return vector(fourth_power(*angle).data(), residual);
  }
};

struct TieAngles {
  TieVectors vectors;

  template <class T>
  bool operator()(const T* angle_k, const T* angle_h, T* residual) const {
    return vectors(fourth_power(*angle_k).data(), fourth_power(*angle_h).data(), residual);
  }
};

ceres::Solver::Options options(std::size_t slides) {
  ceres::Solver::Options options;
  options.linear_solver_type = slides <= 200 ? ceres::DENSE_QR : ceres::SPARSE_NORMAL_CHOLESKY;
  options.num_threads = 1;
  options.logging_type = ceres::SILENT;
  return options;
}

double uniform(std::mt19937_64& random) { return static_cast<double>(random() >> 11) * 0x1p-53; }

// The problem over the angles, whose values are set before each solve.
class AngleProblem {
 public:
  explicit AngleProblem(const Equation1& equation) : equation_(equation), angles_(equation.slides) {
    for (const Equation1::Pull& p : equation.pulls) {
      auto* cost = new PullAngle{{p.target, std::sqrt(p.weight)}};
      problem_.AddResidualBlock(new ceres::AutoDiffCostFunction<PullAngle, 2, 1>(cost), nullptr, angle(p.k));
    }
    for (const Equation1::Tie& t : equation.ties) {
      auto* cost = new TieAngles{{t.turn, std::sqrt(t.weight)}};
      problem_.AddResidualBlock(new ceres::AutoDiffCostFunction<TieAngles, 2, 1, 1>(cost), nullptr, angle(t.k),
                                angle(t.h));
    }
  }

  double minimise(const std::vector<double>& start) {
    angles_ = start;
    ceres::Solver::Options with = options(equation_.slides);
    with.max_num_iterations = 500;
    with.function_tolerance = 1e-12;
    with.gradient_tolerance = 1e-14;
    ceres::Solver::Summary summary;
    ceres::Solve(with, &problem_, &summary);
    if (!summary.IsSolutionUsable()) throw std::runtime_error("Ceres on equation (1): " + summary.message);
    return equation_.at_angles(angles_);
  }
  const std::vector<double>& angles() const { return angles_; }

 private:
  double* angle(int k) { return &angles_[static_cast<std::size_t>(k)]; }

  const Equation1& equation_;
  std::vector<double> angles_;  // Ceres holds its addresses
  ceres::Problem problem_;
};

}  // namespace

std::vector<Eigen::Vector2d> minimise_quadratic(const Equation1& equation) {
  std::vector<Eigen::Vector2d> x(equation.slides, Eigen::Vector2d::UnitX());
  if (x.empty()) return x;
  ceres::Problem problem;
  const auto pull = [&](int k, const Eigen::Vector2d& target, double weight) {
    problem.AddResidualBlock(
        new ceres::AutoDiffCostFunction<PullVector, 2, 2>(new PullVector{target, std::sqrt(weight)}), nullptr,
        x[static_cast<std::size_t>(k)].data());
  };
  for (const Equation1::Pull& p : equation.pulls) pull(p.k, p.target, p.weight);
  for (std::size_t k = 0; k < x.size(); ++k) pull(static_cast<int>(k), Eigen::Vector2d::UnitX(), equation.tie_break);
  for (const Equation1::Tie& t : equation.ties) {
    problem.AddResidualBlock(
        new ceres::AutoDiffCostFunction<TieVectors, 2, 2, 2>(new TieVectors{t.turn, std::sqrt(t.weight)}), nullptr,
        x[static_cast<std::size_t>(t.k)].data(), x[static_cast<std::size_t>(t.h)].data());
  }
  ceres::Solver::Options with = options(equation.slides);
  with.initial_trust_region_radius = 1e16;  // linear: the first step is the whole of it
  with.max_trust_region_radius = 1e20;
  with.max_num_iterations = 4;
  with.function_tolerance = with.gradient_tolerance = with.parameter_tolerance = 0;
  ceres::Solver::Summary summary;
  ceres::Solve(with, &problem, &summary);
  if (!summary.IsSolutionUsable()) throw std::runtime_error("Ceres on equation (1): " + summary.message);
  return x;
}

OrientationSearch search_angles(const Equation1& equation, const std::vector<double>& start, std::size_t starts) {
  OrientationSearch search;
  search.angles = start;
  if (start.empty()) return search;
  AngleProblem problem(equation);
  search.from_start = search.best = problem.minimise(start);
  search.angles = problem.angles();
  std::mt19937_64 random(20170225);  // a fixed seed
  std::vector<double> ends, angles(start.size());
  for (search.starts = 0; search.starts < starts; ++search.starts) {
    for (double& angle : angles) angle = uniform(random) * std::numbers::pi / 2;
    ends.push_back(problem.minimise(angles));
    if (ends.back() >= search.best) continue;
    search.best = ends.back();
    search.angles = problem.angles();
  }
  for (const double end : ends) search.reached += end <= search.best * (1 + 1e-6) ? 1 : 0;
  return search;
}

}  // namespace cagewright::host
