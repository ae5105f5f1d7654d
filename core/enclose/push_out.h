// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/enclose/guarded_move.h"
#include "core/enclose/outside.h"

namespace cagewright {

struct PushOptions {
  double clearance = 0;  // the distance to the model that is wanted, model units
  double gap = 0;        // between cage triangles, and from the model whatever the clearance; model units
  double diagonal = 0;
  int most = 60;      // steps
  int patience = 24;  // steps without a gain, after which it ends
  unsigned threads = 0;
  // Whose model stays out of the way of cage triangles at every step; any: what is enclosed at first stays so.
  MovableCage::Whose guarded = MovableCage::Whose::others;
  // Walls bound their own part's model only, and pass through others' and each other.
  bool own_only = false;
};

// Pushes the cage out until the whole model is inside, at the clearance. Each step is the smallest one that takes every
// model vertex which is outside to the inner side of the nearest wall of its own part, to first order (solve_step.h),
// under the conditions that no cage triangle runs into another one or into another part's model and that sections keep
// their shape; what it would run into beyond first order cuts it short (guarded_move.h). Ends, too, where nothing moves
// any more. Returns the steps. Throws Error(cancelled). The same for any number of threads.
int push_out(MovableCage& movable, const SectionShape& shape, const VertexNeighbours& neighbours,
             const std::vector<int>& vertex_owners, const PushOptions& options, const Progress& progress);

}  // namespace cagewright
