// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_VIEW_WINDOW_DRAWING_ORDER_H
#define CAGEWRIGHT_HOST_VIEW_WINDOW_DRAWING_ORDER_H

#include <cstdint>
#include <vector>

#include "host/file/triangle_mesh.h"

namespace cagewright::host {

// A mesh in an order that is quick to draw, and whose triangle and vertex each of its own is.
struct DrawingOrder {
  TriangleMesh mesh;                     // vertices without a triangle are left out
  std::vector<std::uint32_t> triangles;  // row = triangle here, value = triangle there
  std::vector<std::uint32_t> vertices;   // likewise
};

// Triangles that lie together become neighbours, along a curve through space (Morton, 1966), and vertices are numbered
// as they are used: then a vertex is transformed about once, not once for each triangle. O(m log m).
DrawingOrder drawing_order(const TriangleMesh& mesh);

}  // namespace cagewright::host

#endif
