// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/mesh/connectivity.h"
#include "core/mesh/volume.h"

namespace cagewright {

// Of each component the largest component that it lies inside of; itself where it lies in none. A component lies
// inside a larger one where its extreme vertices along the axes do: none of them outside, at least one of them strictly
// inside (exact tests). Precondition: closed, consistently oriented. O(n log c) for c components, and the pairs of a
// triangle and an extreme vertex whose x and y lie in the triangle's box.
std::vector<int> find_outermost(const IndexedMesh& mesh, const Labels& components, const Volumes& volumes);

}  // namespace cagewright
