// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "core/mesh/half_edge_mesh.h"

namespace cagewright {

// Where the planes of across_limb.h turn: a point strictly within a triangle, so that each crosses two of its edges.
struct Pivot {
  OpenMesh::FaceHandle face;
  Vector3 point, normal;  // the surface's normal about it, unit
  Vector3 along;          // unit, of the triangle's longest edge: a direction that turns with the model
  Vector3 middle;         // of the whole surface, by area
  double diagonal;        // of the model's box
};

// The place of the surface that is nearest to `point`; at an edge or vertex, in the first of its triangles. Triangles
// without a normal are passed over. Precondition: the point is finite. Throws Error(slide_misses_model) where it is
// farther away than tolerance::off_surface; `name` is for the sentence. O(n).
Pivot find_pivot(const HalfEdgeMesh& mesh, const Vector3& point, const std::string& name);

}  // namespace cagewright
