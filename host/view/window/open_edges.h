// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_VIEW_WINDOW_OPEN_EDGES_H
#define CAGEWRIGHT_HOST_VIEW_WINDOW_OPEN_EDGES_H

#include <cstddef>
#include <vector>

#include "host/file/triangle_mesh.h"
#include "host/view/polydata.h"

namespace cagewright::host {

// The edges that only one triangle has, two points each: where the surface ends; no more than `most`. Vertices at the
// same point are one, and triangles with two such corners none. O(n log n).
std::vector<std::vector<Point>> open_edges(const TriangleMesh& mesh, std::size_t most);

}  // namespace cagewright::host

#endif
