// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/mesh/triangle.h"

namespace cagewright {

// All tests are exact for all finite doubles (predicates.h), on closed sets: to touch is to meet. Thread-safe. O(1).

// Whether the corners lie on a line.
bool is_degenerate(const Triangle3& t);

// Precondition: t is not degenerate. The segment may be a point.
bool segment_meets_triangle(const Vector3& p, const Vector3& q, const Triangle3& t);

// Precondition: neither is degenerate.
bool triangles_meet(const Triangle3& s, const Triangle3& t);

// Of two triangles of one mesh, by vertex numbers: whether they meet anywhere but in the vertices and the edge that
// they share; two with the same three vertices do. Precondition: neither is degenerate.
bool triangles_of_mesh_meet(const IndexedMesh& mesh, int s, int t);

}  // namespace cagewright
