// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/segment/segment.h"

namespace cagewright {

// Sets Part::enclosed for whole components that lie inside another (eyes in a head, a cavity), by find_outermost: they
// get no cage of their own; refinement bounds them with the cage of what encloses them. O(n log n) where there is a
// component without slides, else O(parts).
void mark_enclosed(Segmentation& segmentation);

}  // namespace cagewright
