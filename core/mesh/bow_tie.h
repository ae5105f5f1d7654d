// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/mesh/connectivity.h"

namespace cagewright {

// Vertices where several fans meet, ascending. O(n).
std::vector<int> find_bow_ties(const IndexedMesh& mesh, const Labels& fans);

// Gives every fan a vertex of its own: the first fan of a vertex keeps the vertex, the others get copies at the end of
// the points. Edges stay shared as they were. O(n).
void split_bow_ties(IndexedMesh& mesh, const Labels& fans);

}  // namespace cagewright
