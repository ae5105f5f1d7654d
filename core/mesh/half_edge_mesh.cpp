// SPDX-License-Identifier: BSD-3-Clause
// The structure is filled in directly: the edges are known from the checks, and OpenMesh's add_face tells only stderr
// what it refuses.
// g++ 12 takes the storage of a fresh Eigen vector for uninitialised input where OpenMesh appends one.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
#include "core/mesh/half_edge_mesh.h"
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif

#include <string>
#include <vector>

#include "core/error/error.h"
#include "core/mesh/bow_tie.h"
#include "core/mesh/connectivity.h"

template class OpenMesh::PropertyT<Eigen::Vector3d>;

namespace cagewright {
namespace {

[[noreturn]] void refuse(const std::string& what, std::size_t element) {
  ErrorPlace place;
  place.element = element;
  throw Error(ErrorCode::internal, "to_half_edge_mesh was given " + what + ": prepare_model has to run first", place);
}

void require_triangles(const IndexedMesh& mesh) {
  std::vector<bool> used(static_cast<std::size_t>(mesh.points.rows()), false);
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    const auto corner = mesh.triangles.row(t);
    if (corner.minCoeff() < 0 || corner.maxCoeff() >= mesh.points.rows()) {
      refuse("triangle " + std::to_string(t) + ", which names a vertex that is not there", static_cast<std::size_t>(t));
    }
    if (corner[0] == corner[1] || corner[1] == corner[2] || corner[2] == corner[0]) {
      refuse("triangle " + std::to_string(t) + ", which names a vertex twice", static_cast<std::size_t>(t));
    }
    for (const int v : corner) used[v] = true;
  }
  for (std::size_t v = 0; v < used.size(); ++v) {
    if (!used[v]) refuse("vertex " + std::to_string(v) + ", which no triangle uses", v);
  }
}

std::string edge_text(const Triangles& triangles, int half_edge) {
  return "the edge from vertex " + std::to_string(from_vertex(triangles, half_edge)) + " to " +
         std::to_string(to_vertex(triangles, half_edge));
}

void require_oriented_manifold(const IndexedMesh& mesh, const Connectivity& connectivity) {
  const Triangles& triangles = mesh.triangles;
  for (int e = 0; e < connectivity.edges.count(); ++e) {
    const auto pair = connectivity.edges.of(e);
    const int h = pair.front();
    const std::size_t triangle = static_cast<std::size_t>(h / 3);
    if (pair.size() != 2) {
      refuse(edge_text(triangles, h) + ", which has " + std::to_string(pair.size()) + " triangles", triangle);
    }
    if (from_vertex(triangles, h) == from_vertex(triangles, pair[1])) {
      refuse(edge_text(triangles, h) + ", whose triangles run it in the same direction", triangle);
    }
  }
  const std::vector<int> bow_ties = find_bow_ties(mesh, connectivity.fans);
  if (!bow_ties.empty()) {
    refuse("vertex " + std::to_string(bow_ties.front()) + ", where several fans meet",
           static_cast<std::size_t>(bow_ties.front()));
  }
}

}  // namespace

HalfEdgeMesh to_half_edge_mesh(const IndexedMesh& mesh) {
  require_triangles(mesh);
  const Connectivity connectivity = connect(mesh);
  require_oriented_manifold(mesh, connectivity);

  using namespace OpenMesh;
  const std::vector<int> opposite = find_opposites(connectivity.edges);
  HalfEdgeMesh result;
  result.resize(static_cast<std::size_t>(mesh.points.rows()), static_cast<std::size_t>(connectivity.edges.count()),
                static_cast<std::size_t>(mesh.triangles.rows()));
  std::vector<HalfedgeHandle> handle(opposite.size());
  int edges = 0;
  for (std::size_t h = 0; h < handle.size(); ++h) {
    if (handle[h].is_valid()) continue;
    handle[h] = HalfedgeHandle(2 * edges);
    handle[opposite[h]] = HalfedgeHandle(2 * edges + 1);
    ++edges;
  }
  for (std::size_t h = 0; h < handle.size(); ++h) {
    const int half_edge = static_cast<int>(h);
    const FaceHandle face(half_edge / 3);
    const VertexHandle from(from_vertex(mesh.triangles, half_edge));
    result.set_vertex_handle(handle[h], VertexHandle(to_vertex(mesh.triangles, half_edge)));
    result.set_next_halfedge_handle(handle[h], handle[next_in_triangle(half_edge)]);
    result.set_face_handle(handle[h], face);
    if (half_edge % 3 == 0) result.set_halfedge_handle(face, handle[h]);
    if (!result.halfedge_handle(from).is_valid()) result.set_halfedge_handle(from, handle[h]);
  }
  for (Eigen::Index v = 0; v < mesh.points.rows(); ++v) {
    result.set_point(VertexHandle(static_cast<int>(v)), mesh.points.row(v).transpose());
  }
  return result;
}

IndexedMesh to_indexed_mesh(const HalfEdgeMesh& mesh) {
  IndexedMesh result;
  result.points.resize(static_cast<Eigen::Index>(mesh.n_vertices()), 3);
  result.triangles.resize(static_cast<Eigen::Index>(mesh.n_faces()), 3);
  for (const auto v : mesh.all_vertices()) result.points.row(v.idx()) = mesh.point(v).transpose();
  for (const auto f : mesh.all_faces()) {
    auto h = mesh.halfedge_handle(f);
    for (int i = 0; i < 3; ++i, h = mesh.next_halfedge_handle(h)) {
      result.triangles(f.idx(), i) = mesh.from_vertex_handle(h).idx();
    }
  }
  return result;
}

}  // namespace cagewright
