// SPDX-License-Identifier: BSD-3-Clause
#include "core/segment/cut_mesh.h"

#include "core/error/error.h"
#include "core/mesh/tolerance.h"

namespace cagewright {
namespace {

using OpenMesh::HalfedgeHandle;
using OpenMesh::VertexHandle;

[[noreturn]] void fail_touching(const std::vector<std::string>& names, int earlier, int slide, const Vector3& place) {
  ErrorPlace where;
  where.slide = static_cast<std::size_t>(earlier);
  where.other_slide = static_cast<std::size_t>(slide);
  where.point = place;
  throw Error(ErrorCode::slides_touch,
              "slide '" + names[static_cast<std::size_t>(earlier)] + "' meets slide '" +
                  names[static_cast<std::size_t>(slide)] + "' at " + to_text(place) + ": move one of them",
              where);
}

}  // namespace

void CutMesh::check_apart(const PlaneLoop& loop, int slide, const std::vector<std::string>& names) const {
  for (std::size_t i = 0; i < loop.crossed.size(); ++i) {
    const HalfedgeHandle h = loop.crossed[i];
    const Vector3 place = loop.points.row(static_cast<Eigen::Index>(i));
    if (const int earlier = slide_of(mesh_.edge_handle(h)); earlier >= 0) fail_touching(names, earlier, slide, place);
    for (const VertexHandle v : {mesh_.from_vertex_handle(h), mesh_.to_vertex_handle(h)}) {
      const int earlier = owner(vertex_slide_, v.idx());
      if (earlier >= 0 && (mesh_.point(v) - place).norm() < tolerance::touching_loops * diagonal_)
        fail_touching(names, earlier, slide, place);
    }
  }
}

std::vector<HalfedgeHandle> CutMesh::cut(const PlaneLoop& loop, int slide, const std::vector<std::string>& names) {
  check_apart(loop, slide, names);
  // Splitting the crossed edges one by one leaves an edge between neighbours on the loop, whichever goes first: a
  // crossed triangle has two crossed edges, and the second split triangulates the quad that holds both points.
  std::vector<VertexHandle> on_loop;
  on_loop.reserve(loop.crossed.size());
  for (std::size_t i = 0; i < loop.crossed.size(); ++i) {
    const VertexHandle v = mesh_.add_vertex(Vector3(loop.points.row(static_cast<Eigen::Index>(i))));
    mesh_.split(mesh_.edge_handle(loop.crossed[i]), v);
    on_loop.push_back(v);
  }
  blocks_.add_new_edges(mesh_);
  vertex_slide_.resize(mesh_.n_vertices(), -1);
  edge_slide_.resize(mesh_.n_edges(), -1);
  std::vector<HalfedgeHandle> walls;
  walls.reserve(on_loop.size());
  for (std::size_t i = 0; i < on_loop.size(); ++i) {
    const HalfedgeHandle h = mesh_.find_halfedge(on_loop[i], on_loop[(i + 1) % on_loop.size()]);
    if (!h.is_valid()) throw Error(ErrorCode::internal, "segment: a loop edge is missing after the split");
    edge_slide_[static_cast<std::size_t>(mesh_.edge_handle(h).idx())] = slide;
    vertex_slide_[static_cast<std::size_t>(on_loop[i].idx())] = slide;
    walls.push_back(h);
  }
  return walls;
}

}  // namespace cagewright
