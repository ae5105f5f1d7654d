// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "core/mesh/types.h"

namespace cagewright {

namespace morton {

inline constexpr double steps = 2097151;  // 2^21 - 1 along each axis

// The lower 21 bits, two zeros after each.
inline std::uint64_t spread(std::uint64_t bits) {
  bits = (bits | bits << 32) & 0x1f00000000ffffu;
  bits = (bits | bits << 16) & 0x1f0000ff0000ffu;
  bits = (bits | bits << 8) & 0x100f00f00f00f00fu;
  bits = (bits | bits << 4) & 0x10c30c30c30c30c3u;
  return (bits | bits << 2) & 0x1249249249249249u;
}

}  // namespace morton

// Where a point of the unit cube (coordinates from 0 to 1) is on a Morton curve, which fills it: what is near on the
// curve is near in space. O(1).
inline std::uint64_t morton_code(const Vector3& place) {
  std::uint64_t code = 0;
  for (int axis = 0; axis < 3; ++axis)
    code |= morton::spread(static_cast<std::uint64_t>(place[axis] * morton::steps)) << axis;
  return code;
}

}  // namespace cagewright
