// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/enclose/guarded_move.h"

namespace cagewright {

// Takes the sections of a cage that encloses its model into their planes and into shape, as far as nothing comes into
// the way, and so that it encloses the model all the time. Sections that do not get there, exactly but for rounding,
// are released from `shape`. Precondition: `guard`, for any model, objects to nothing. `free_shape` asks for nothing.
// Throws Error(cancelled). The same for any number of threads.
void flatten(MovableCage& movable, SectionShape& shape, const SectionShape& free_shape,
             const std::vector<int>& vertex_owners, const Guard& guard, double diagonal, const Progress& progress);

}  // namespace cagewright
