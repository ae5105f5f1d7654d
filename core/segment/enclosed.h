// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/segment/segment.h"

namespace cagewright {

// Sets Part::enclosed for whole components that lie inside the rest of the model (eyes in a head, a cavity): the cage
// of what encloses them bounds them too. Judged by the winding number of the rest round a sample of their vertices.
// O(n) a component without slides whose box lies in that of another part.
void mark_enclosed(Segmentation& segmentation);

}  // namespace cagewright
