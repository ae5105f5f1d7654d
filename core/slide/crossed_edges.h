// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/mesh/half_edge_mesh.h"

// How the loop along which a plane meets a closed mesh goes from edge to edge. An edge is crossed where its ends lie on
// different sides; it is held by the half-edge that runs from behind the plane to ahead of it. O(1).
namespace cagewright {

// Which side a vertex at this signed distance from the plane is on. On the plane counts as ahead, so that loops never
// branch.
inline bool is_ahead(double height) { return height >= 0; }

// The next crossed half-edge, in the triangle on the right of `crossed`: that way the loop round solid material runs
// counter-clockwise about the normal. `third`: the height of that triangle's vertex which is not on the edge.
inline OpenMesh::VertexHandle third_vertex(const HalfEdgeMesh& mesh, OpenMesh::HalfedgeHandle crossed) {
  return mesh.to_vertex_handle(mesh.next_halfedge_handle(mesh.opposite_halfedge_handle(crossed)));
}
inline OpenMesh::HalfedgeHandle next_crossed(const HalfEdgeMesh& mesh, OpenMesh::HalfedgeHandle crossed, double third) {
  const OpenMesh::HalfedgeHandle back = mesh.opposite_halfedge_handle(crossed);
  return is_ahead(third) ? mesh.next_halfedge_handle(back) : mesh.prev_halfedge_handle(back);
}

// Where the plane crosses an edge between points at these heights, of which only `ahead` is 0 or more.
inline Vector3 crossing_point(const Vector3& from, double behind, const Vector3& to, double ahead) {
  return from + behind / (behind - ahead) * (to - from);
}

}  // namespace cagewright
