// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/enclose/guarded_move.h"

namespace cagewright {

// Where the cage begins to be pushed out from: as it is, with its sections in shape; and where it runs into itself or
// into other parts' model, sections and caps drawn back, step by step, to the rectangles round the slides' loops and
// then towards the slides' centres, until it does not or nothing is left to draw back. So limbs that are close to each
// other meet the gap between them from inside. Returns whether nothing is in the way.
bool draw_back(MovableCage& movable, const SectionShape& shape, const std::vector<SectionFrame>& sections,
               const Guard& guard, double margin);

}  // namespace cagewright
