// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/enclose/push_out.h"

namespace cagewright {

// Takes the walls of a cage out until each keeps options.clearance from its own part's model, through other parts'
// model and through each other: what merge_limbs.h makes one of. In stages: all walls go out by their normals, and are
// then pushed where that is not enough. Returns the steps of push_out. What cannot be kept is not. Throws
// Error(cancelled). The same for any number of threads.
int grow_through(MovableCage& movable, const SectionShape& shape, const VertexNeighbours& neighbours,
                 const std::vector<int>& vertex_owners, const PushOptions& options, const Progress& progress);

}  // namespace cagewright
