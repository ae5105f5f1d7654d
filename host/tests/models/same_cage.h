// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_TESTS_MODELS_SAME_CAGE_H
#define CAGEWRIGHT_HOST_TESTS_MODELS_SAME_CAGE_H

#include <string>

#include "host/tests/models/surface.h"

namespace cagewright::host {

// In what two cages differ, as a sentence; "" where vertex i of one is within `tolerance` (a length) of vertex i of the
// other and the triangles are the same numbers in the same order.
std::string difference(const Surface& a, const Surface& b, double tolerance);

// The same for cages that may list vertices and triangles in any order: each vertex's partner is the nearest.
// O(n * n) in the vertices.
std::string difference_in_any_order(const Surface& a, const Surface& b, double tolerance);

}  // namespace cagewright::host

#endif
