// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "core/mesh/connectivity.h"

namespace cagewright {

// Where a surface touches itself or another along an edge, the weld brings four triangles and more together at one edge
// though the input had told them apart by its vertices. This takes them apart again: an edge per pair of triangles that
// name the same two input rows, and one for a pair that is left over. Edges of triangles that coincide stay as they
// are. Empty where nothing was taken apart, or where the ends of such edges could not be split into vertices of their
// own, so that the edges would still coincide. `given` are the triangles by input rows, `edges` those of the welded
// `triangles`. O(n log k), k = triangles at an edge.
struct SeparatedEdges {
  EdgeTable edges;
  Labels fans;
};
std::optional<SeparatedEdges> separate_welded_edges(const Triangles& triangles, const Triangles& given,
                                                    const EdgeTable& edges);

}  // namespace cagewright
