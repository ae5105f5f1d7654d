// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include <OpenMesh/Core/Geometry/EigenVectorT.hh>  // after the kernel: it specialises its vector_traits

#include "core/mesh/types.h"

// Instantiated in half_edge_mesh.cpp only, which knows how to keep g++ 12 quiet about it.
extern template class OpenMesh::PropertyT<Eigen::Vector3d>;

namespace cagewright {

struct HalfEdgeMeshTraits : OpenMesh::DefaultTraits {
  using Point = Eigen::Vector3d;
  using Normal = Eigen::Vector3d;
  VertexAttributes(OpenMesh::Attributes::None);
  HalfedgeAttributes(OpenMesh::Attributes::PrevHalfedge);
  EdgeAttributes(OpenMesh::Attributes::None);
  FaceAttributes(OpenMesh::Attributes::None);
};

// Closed triangle meshes with double-precision positions.
using HalfEdgeMesh = OpenMesh::TriMesh_ArrayKernelT<HalfEdgeMeshTraits>;

// Builds the half-edge structure. Precondition: a closed, consistently oriented 2-manifold (see prepare_model); vertex
// and face indices are the rows of `mesh`. Throws Error(internal) where the precondition is broken. O(n).
HalfEdgeMesh to_half_edge_mesh(const IndexedMesh& mesh);

// Vertex and face rows in index order. Precondition: nothing was deleted. O(n).
IndexedMesh to_indexed_mesh(const HalfEdgeMesh& mesh);

}  // namespace cagewright
