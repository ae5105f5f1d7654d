// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>

#include "core/enclose/movable_cage.h"
#include "core/enclose/section_shape.h"
#include "core/enclose/solve_step.h"

namespace cagewright {

// What a move must not bring about: a cage triangle without area, one that meets another, one that comes to a model
// triangle of `whose` nearer than its clearance, a section out of shape. Triangles that are exempt may.
struct Guard {
  MovableCage::Whose whose = MovableCage::Whose::any;
  std::vector<double> clearance;  // of each cage triangle, model units
  double gap = 0;                 // between cage triangles without a common vertex
  std::vector<char> exempt;       // of each cage triangle
  unsigned threads = 0;
  bool through_cage = false;  // cage triangles may meet each other
};

// Of each cage triangle whether the guard objects to it as it is. O(triangles * log n + triangles^2).
std::vector<char> find_objections(const MovableCage& movable, const Guard& guard);

struct GuardedMove {
  double share = 0;                       // of the step, mean over the vertices that were to move
  std::vector<std::pair<int, int>> hits;  // cage and model triangle: those that shortened a step, ascending
};

// Moves all vertices by their steps at once, and takes back as much of the steps of the vertices of any triangle that
// the guard objects to as it takes until it does not. The same for any number of threads.
GuardedMove move_guarded(MovableCage& movable, const SectionShape& shape, const Points& step, const Guard& guard);

// The same by the solver's steps: what a step runs into, as it does so, becomes a contact of the solver, and it solves
// again, a few times, before anything is taken back. So vertices that hold a triangle together give way together.
// `slack` (model units): left beyond the clearance.
GuardedMove move_guarded(MovableCage& movable, const SectionShape& shape, StepSolver& solver, const Guard& guard,
                         double slack);

}  // namespace cagewright
