// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_VIEW_WINDOW_OPEN_EDGES_H
#define CAGEWRIGHT_HOST_VIEW_WINDOW_OPEN_EDGES_H

#include <vector>

#include "host/file/triangle_mesh.h"
#include "host/view/polydata.h"

namespace cagewright::host {

// The edges that only one triangle has, two points each: where the surface ends. Vertices at the same point are one.
// O(n log n).
std::vector<std::vector<Point>> open_edges(const TriangleMesh& mesh);

}  // namespace cagewright::host

#endif
