// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_VALIDATE_CHECK_H
#define CAGEWRIGHT_HOST_VALIDATE_CHECK_H

#include <cstddef>
#include <functional>
#include <string>

#include <Eigen/Core>

namespace cagewright::host {

// One claim about a stage of the plug-in, and how far what was recomputed is from what the plug-in says.
struct Check {
  std::string stage;       // as the plug-in calls it: "segment", "orient", "refine", "enclose"
  std::string claim;       // what was compared, as a sentence without its full stop
  double tolerance = 0;    // of the deviation
  std::string unit;        // of tolerance and deviation: "of the diagonal", "relative"
  double worst = 0;        // the largest deviation; NaN where one was not a number
  std::size_t count = 0;   // of comparisons
  std::string fault = {};  // "" where the claim holds; else a sentence that names the stage and the place

  bool holds() const { return fault.empty(); }

  // Takes in one comparison. Where it is the worst so far beyond the tolerance (what is no number is worst of all), the
  // fault is "STAGE: SENTENCE". `sentence` is only called then.
  void offer(double deviation, const std::function<std::string()>& sentence);
};

// Six digits; "(x, y, z)" for points.
std::string text_of(double figure);
std::string text_of(const Eigen::Vector3d& point);

}  // namespace cagewright::host

#endif
