// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_VALIDATE_ORIENTATION_CHECKS_H
#define CAGEWRIGHT_HOST_VALIDATE_ORIENTATION_CHECKS_H

#include <vector>

#include "host/validate/check.h"
#include "host/validate/observed_cage.h"

namespace cagewright::host {

// Energies of equation (1), and the checks that rest on them.
struct OrientationFigures {
  double linear = 0;       // at the linear solution, each x_k taken to length 1
  double plugin = 0;       // at the sections as the plug-in turned them
  double from_plugin = 0;  // the least that Ceres finds from there
  double best = 0;         // and from random starts, too
  std::size_t starts = 0, reached = 0;
  double linear_off = 0, plugin_off = 0;  // over the best, less 1
};

// The linear solution by Ceres; the rectangles from the directions; the search over the angles from `starts` random
// starts: more than 5 % above the best found is a fault.
struct OrientationReport {
  OrientationFigures figures;
  std::vector<Check> checks;
};
OrientationReport check_orientation(const ObservedCage& seen, std::size_t starts);

}  // namespace cagewright::host

#endif
