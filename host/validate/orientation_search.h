// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_VALIDATE_ORIENTATION_SEARCH_H
#define CAGEWRIGHT_HOST_VALIDATE_ORIENTATION_SEARCH_H

#include <vector>

#include "host/validate/equation_1.h"

namespace cagewright::host {

// The minimiser of (1) with its tie-break as a quadratic form in all x, by Ceres. Throws std::runtime_error where Ceres
// finds none.
std::vector<Eigen::Vector2d> minimise_quadratic(const Equation1& equation);

// (1) over the angles, which is not quadratic: x_k is (cos 4 angle_k, sin 4 angle_k).
struct OrientationSearch {
  double from_start = 0;       // the least that Ceres reaches from `start`
  double best = 0;             // from `start` and all random starts
  std::size_t starts = 0;      // random ones
  std::size_t reached = 0;     // of them: within a millionth of the best
  std::vector<double> angles;  // of the best
};

// Random starts are the same in every run. Precondition: one angle for each slide. O(starts x slides).
OrientationSearch search_angles(const Equation1& equation, const std::vector<double>& start, std::size_t starts);

}  // namespace cagewright::host

#endif
