// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/enclose/guarded_move.h"

namespace cagewright {

struct TightenOptions {
  std::vector<double> clearance;  // of each cage triangle, model units
  double gap = 0;                 // between cage triangles without a common vertex
  double diagonal = 0;
  unsigned threads = 0;
};

// Takes volume off: all vertices at once go against the gradient of the cage's volume as far as, to first order,
// nothing comes into their way (solve_step.h), and what does beyond that cuts them short (guarded_move.h); again, with
// shorter steps, until hardly any volume comes off. Returns the steps. Precondition: nothing is in the way of any
// triangle, and sections are in shape; both stays so. Throws Error(cancelled). The same for any number of threads.
int tighten(MovableCage& movable, const SectionShape& shape, const std::vector<int>& vertex_owners,
            const TightenOptions& options, const Progress& progress);

}  // namespace cagewright
