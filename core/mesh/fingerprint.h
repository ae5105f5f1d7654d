// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "core/mesh/types.h"

namespace cagewright {

// A 64-bit hash of the bytes of the points and of the triangles, and of how many there are. Not cryptographic. O(n).
std::uint64_t fingerprint(const IndexedMesh& mesh);

}  // namespace cagewright
