// SPDX-License-Identifier: BSD-3-Clause
#include "core/enclose/tighten.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "core/enclose/find_contacts.h"
#include "core/enclose/solve_step.h"
#include "core/error/error.h"
#include "core/mesh/tolerance.h"

namespace cagewright {
namespace {

constexpr int most_steps = 60;
constexpr double shorter = 0.5;

// Every vertex alone would go `longest` against the gradient of the volume; where it takes more off, it gives way less.
void set_pull(const MovableCage& movable, StepProblem& problem) {
  const Points& planes = problem.plane_normals;
  double mean = 0;
  Points gradients(movable.vertex_count(), 3);
  for (int v = 0; v < movable.vertex_count(); ++v) {
    const Vector3 n = planes.row(v), g = movable.volume_gradient(v);
    gradients.row(v) = (g - n * n.dot(g)).transpose();
    mean += gradients.row(v).norm() / movable.vertex_count();
  }
  problem.pull = Points::Zero(movable.vertex_count(), 3);
  for (int v = 0; v < movable.vertex_count(); ++v) {
    const double size = gradients.row(v).norm();
    if (size > 0) problem.pull.row(v) = -problem.longest / size * gradients.row(v);
    problem.mobility[static_cast<std::size_t>(v)] = mean / std::max(size, 0.25 * mean);
  }
}

}  // namespace

int tighten(MovableCage& movable, const SectionShape& shape, const std::vector<int>& vertex_owners,
            const TightenOptions& options, const Progress& progress) {
  const auto count = static_cast<std::size_t>(movable.triangle_count());
  const Guard guard{MovableCage::Whose::any, options.clearance, options.gap, std::vector<char>(count, 0),
                    options.threads};
  StepProblem problem;
  problem.mobility.resize(static_cast<std::size_t>(movable.vertex_count()));
  problem.plane_normals = shape.plane_normals();
  problem.longest = tolerance::first_tightening_step * options.diagonal;
  std::vector<std::pair<int, int>> hits;
  double volume = movable.volume();
  for (int step = 0; step < most_steps; ++step) {
    if (progress && !progress(static_cast<double>(step) / most_steps))
      throw Error(ErrorCode::cancelled, "cancelled while the cage was tightened");
    ContactQuery query;
    query.clearance = options.clearance;
    for (double& clearance : query.clearance) clearance += tolerance::contact_slack * options.diagonal;
    query.gap = 2 * options.gap;
    query.longest = problem.longest;
    query.hits = hits;
    query.threads = options.threads;
    Contacts contacts = find_contacts(movable, vertex_owners, query);
    for (Contact& contact : contacts) contact.least = std::min(contact.least, 0.0);
    shape.add_contacts(movable.points(), contacts);
    set_pull(movable, problem);
    const Points from = movable.points();
    StepSolver solver(problem);
    solver.add(contacts);
    GuardedMove moved = move_guarded(movable, shape, solver, guard, tolerance::contact_slack * options.diagonal);
    hits = std::move(moved.hits);
    const double now = movable.volume();
    if (now >= volume) movable.place_all(from);
    if (volume - now <= tolerance::least_tightening * volume) {
      problem.longest *= shorter;
      if (problem.longest < tolerance::least_tightening_step * options.diagonal) return step + 1;
    }
    volume = std::min(volume, now);
  }
  return most_steps;
}

}  // namespace cagewright
