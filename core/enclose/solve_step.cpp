// SPDX-License-Identifier: BSD-3-Clause
#include "core/enclose/solve_step.h"

#include <algorithm>
#include <cmath>

namespace cagewright {
namespace {

constexpr double hardly = 1e-6;   // a share of a gradient's square: what is left of it across the planes moves nothing
constexpr double settled = 1e-3;  // of the longest step: a sweep that changes contacts less ends the solution
constexpr double over = 1.3;      // relaxation

Vector3 across_plane(const Vector3& n, const Vector3& d) { return d - n * n.dot(d); }

}  // namespace

StepSolver::StepSolver(const StepProblem& problem) : problem_(problem), step_(problem.pull) {
  for (Eigen::Index v = 0; v < step_.rows(); ++v)
    step_.row(v) = across_plane(problem.plane_normals.row(v), step_.row(v)).transpose();
}

void StepSolver::add(const Contacts& contacts) {
  for (const Contact& contact : contacts) {
    Row row{contact};
    double squared = 0;
    for (int i = 0; i < contact.count; ++i) {
      auto& [v, gradient] = row.contact.terms[static_cast<std::size_t>(i)];
      squared += gradient.squaredNorm();
      gradient = across_plane(problem_.plane_normals.row(v), gradient);
      row.give += problem_.mobility[static_cast<std::size_t>(v)] * gradient.squaredNorm();
    }
    if (!(row.give > hardly * squared)) continue;
    row.give += contact.softness;
    rows_.push_back(row);
  }
}

// Returns by how much the contact's sum changes.
double StepSolver::change_force(Row& row) {
  double lacking = row.contact.least - row.contact.softness * row.force;
  for (int i = 0; i < row.contact.count; ++i) {
    const auto& [v, gradient] = row.contact.terms[static_cast<std::size_t>(i)];
    lacking -= gradient.x() * step_(v, 0) + gradient.y() * step_(v, 1) + gradient.z() * step_(v, 2);
  }
  if (lacking <= 0 && row.force == 0) return 0;
  const double force = std::max(0.0, row.force + over * lacking / row.give), change = force - row.force;
  row.force = force;
  for (int i = 0; i < row.contact.count; ++i) {
    const auto& [v, gradient] = row.contact.terms[static_cast<std::size_t>(i)];
    step_.row(v) += (change * problem_.mobility[static_cast<std::size_t>(v)]) * gradient.transpose();
  }
  return std::abs(change) * row.give;
}

Points StepSolver::solve(int sweeps) {
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    double most = 0;
    for (Row& row : rows_) most = std::max(most, change_force(row));
    if (most < settled * problem_.longest) break;
  }
  Points step = step_;
  for (Eigen::Index v = 0; v < step.rows(); ++v)
    if (const double length = step.row(v).norm(); length > problem_.longest) step.row(v) *= problem_.longest / length;
  return step;
}

}  // namespace cagewright
