// SPDX-License-Identifier: BSD-3-Clause
#include "core/error/error.h"

#include <cstdio>

namespace cagewright {

std::string to_text(const Vector3& point) {
  char text[96];
  std::snprintf(text, sizeof text, "(%.6g, %.6g, %.6g)", point.x(), point.y(), point.z());
  return text;
}

}  // namespace cagewright
