// SPDX-License-Identifier: BSD-3-Clause
#include "core/enclose/flatten.h"

#include <algorithm>

#include "core/enclose/find_contacts.h"
#include "core/error/error.h"
#include "core/mesh/tolerance.h"

namespace cagewright {
namespace {

constexpr int most_steps = 60;

// Puts the cage at `target` where the guard has nothing against it.
bool place_if_allowed(MovableCage& movable, const SectionShape& shape, const Guard& guard, const Points& target) {
  const Points from = movable.points();
  movable.place_all(target);
  bool is_allowed = true;
  for (int k = 0; k < shape.section_count(); ++k) is_allowed = is_allowed && shape.is_sound(k, target);
  if (is_allowed) {
    const std::vector<char> objections = find_objections(movable, guard);
    is_allowed = std::find(objections.begin(), objections.end(), 1) == objections.end();
  }
  if (!is_allowed) movable.place_all(from);
  return is_allowed;
}

// Section by section, the nearest to their planes first.
void place_or_release(MovableCage& movable, SectionShape& shape, const SectionShape& free_shape, const Guard& guard) {
  Points target = movable.points();
  shape.put_in_shape(target);
  std::vector<std::pair<double, int>> order;
  for (int k = 0; k < shape.section_count(); ++k) {
    if (!shape.is_whole(k)) continue;
    double farthest = 0;
    for (int i = 0; i < 4; ++i)
      farthest = std::max(farthest, (target - movable.points()).row(shape.corner(k, i)).norm());
    order.emplace_back(farthest, k);
  }
  std::sort(order.begin(), order.end());
  for (const auto& [distance, k] : order) {
    Points next = movable.points();
    for (int i = 0; i < 4; ++i) next.row(shape.corner(k, i)) = target.row(shape.corner(k, i));
    if (!shape.is_sound(k, next) || !place_if_allowed(movable, free_shape, guard, next)) shape.release(k);
  }
}

}  // namespace

void flatten(MovableCage& movable, SectionShape& shape, const SectionShape& free_shape,
             const std::vector<int>& vertex_owners, const Guard& guard, double diagonal, const Progress& progress) {
  StepProblem problem;
  problem.mobility.assign(static_cast<std::size_t>(movable.vertex_count()), 1);
  problem.plane_normals = free_shape.plane_normals();
  problem.longest = tolerance::first_tightening_step * diagonal;
  for (int step = 0; step < most_steps; ++step) {
    if (progress && !progress(static_cast<double>(step) / most_steps))
      throw Error(ErrorCode::cancelled, "cancelled while the cage's sections were put into their planes");
    Points target = movable.points();
    shape.put_in_shape(target);
    problem.pull = target - movable.points();
    const double farthest = problem.pull.rowwise().norm().maxCoeff();
    if (farthest <= problem.longest && place_if_allowed(movable, shape, guard, target)) return;
    for (Eigen::Index v = 0; v < problem.pull.rows(); ++v)
      if (const double length = problem.pull.row(v).norm(); length > problem.longest)
        problem.pull.row(v) *= problem.longest / length;
    ContactQuery query;
    query.clearance = guard.clearance;
    query.gap = 2 * guard.gap;
    query.longest = problem.longest;
    query.threads = guard.threads;
    Contacts contacts = find_contacts(movable, vertex_owners, query);
    for (Contact& contact : contacts) contact.least = std::min(contact.least, 0.0);
    StepSolver solver(problem);
    solver.add(contacts);
    const Points before = movable.points();
    move_guarded(movable, free_shape, solver, guard, tolerance::contact_slack * diagonal);
    if ((movable.points() - before).rowwise().norm().maxCoeff() < tolerance::contact_slack * diagonal) break;
  }
  place_or_release(movable, shape, free_shape, guard);
}

}  // namespace cagewright
