// SPDX-License-Identifier: BSD-3-Clause
#include "host/validate/check.h"

#include <cmath>
#include <cstdio>

namespace cagewright::host {

void Check::offer(double deviation, const std::function<std::string()>& sentence) {
  ++count;
  if (deviation <= worst || std::isnan(worst)) return;
  worst = deviation;
  if (deviation <= tolerance) return;
  fault = stage + ": " + sentence();
}

std::string text_of(double figure) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", figure);
  return text;
}

std::string text_of(const Eigen::Vector3d& point) {
  char text[96];
  std::snprintf(text, sizeof text, "(%.6g, %.6g, %.6g)", point.x(), point.y(), point.z());
  return text;
}

}  // namespace cagewright::host
