// SPDX-License-Identifier: BSD-3-Clause
#include "core/error/error.h"

#include <cmath>
#include <cstdio>

namespace cagewright {

std::string to_text(const Vector3& point) {
  const double rounding = point.allFinite() ? 1e-9 * point.cwiseAbs().maxCoeff() : 0;
  const auto shown = [&](double x) { return std::abs(x) <= rounding ? 0.0 : x; };
  char text[96];
  std::snprintf(text, sizeof text, "(%.6g, %.6g, %.6g)", shown(point.x()), shown(point.y()), shown(point.z()));
  return text;
}

}  // namespace cagewright
