// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/error/error.h"
#include "core/mesh/half_edge_mesh.h"
#include "core/tests/expect_error.h"
#include "core/tests/meshes.h"

namespace cagewright {
namespace {

TEST(HalfEdgeMesh, GivesBackWhatItWasMadeOf) {
  for (const IndexedMesh& mesh : {meshes::tetrahedron(), meshes::icosphere(2), meshes::perforated_plate(3),
                                  meshes::shuffled(meshes::torus(3, 1, 12, 7), 2), meshes::hollow_sphere(1)}) {
    const IndexedMesh back = to_indexed_mesh(to_half_edge_mesh(mesh));
    EXPECT_EQ(back.points, mesh.points);
    EXPECT_EQ(back.triangles, mesh.triangles);
  }
}

TEST(HalfEdgeMesh, AgreesWithOpenMeshesOwnBuilder) {
  const IndexedMesh mesh = meshes::shuffled(meshes::perforated_plate(2), 4);
  const HalfEdgeMesh ours = to_half_edge_mesh(mesh);
  HalfEdgeMesh theirs;
  for (const auto& point : mesh.points.rowwise()) theirs.add_vertex(point.transpose());
  for (const auto& corner : mesh.triangles.rowwise()) {
    theirs.add_face(HalfEdgeMesh::VertexHandle(corner[0]), HalfEdgeMesh::VertexHandle(corner[1]),
                    HalfEdgeMesh::VertexHandle(corner[2]));
  }
  EXPECT_EQ(ours.n_edges(), theirs.n_edges());
  for (const auto h : theirs.all_halfedges()) {
    const auto same = ours.find_halfedge(theirs.from_vertex_handle(h), theirs.to_vertex_handle(h));
    ASSERT_TRUE(same.is_valid());
    EXPECT_EQ(ours.face_handle(same), theirs.face_handle(h));
    EXPECT_EQ(ours.to_vertex_handle(ours.next_halfedge_handle(same)),
              theirs.to_vertex_handle(theirs.next_halfedge_handle(h)));
    EXPECT_EQ(ours.prev_halfedge_handle(ours.next_halfedge_handle(same)), same);
  }
  for (const auto v : theirs.all_vertices()) EXPECT_EQ(ours.valence(v), theirs.valence(v));
}

TEST(HalfEdgeMesh, TakesTwoTrianglesBackToBack) {
  const IndexedMesh mesh{meshes::tetrahedron().points.topRows(3), (Triangles(2, 3) << 0, 1, 2, 2, 1, 0).finished()};
  const HalfEdgeMesh pillow = to_half_edge_mesh(mesh);
  EXPECT_EQ(pillow.n_edges(), 3u);
  for (const auto v : pillow.vertices()) EXPECT_EQ(pillow.valence(v), 2u);
}

TEST(HalfEdgeMesh, RefusesWhatIsNoClosedOrientedManifold) {
  IndexedMesh turned = meshes::tetrahedron(), twice = turned, out_of_range = turned, unused = turned;
  std::swap(turned.triangles(0, 1), turned.triangles(0, 2));
  twice.triangles(1, 1) = twice.triangles(1, 0);
  out_of_range.triangles(1, 1) = 4;
  unused.points.conservativeResize(5, 3);
  unused.points.row(4).setZero();
  const std::vector<std::pair<IndexedMesh, std::string>> refused = {
      {meshes::without_triangle(meshes::tetrahedron(), 0), "the edge from vertex 0 to 1, which has 1 triangles"},
      {meshes::bow_tie_edge(), "which has 4 triangles"},
      {meshes::bow_tie(), "vertex 0, where several fans meet"},
      {turned, "run it in the same direction"},
      {twice, "triangle 1, which names a vertex twice"},
      {out_of_range, "triangle 1, which names a vertex that is not there"},
      {unused, "vertex 4, which no triangle uses"}};
  for (const auto& [mesh, words] : refused) {
    expect_error([&] { to_half_edge_mesh(mesh); }, ErrorCode::internal, {words, "prepare_model"});
  }
}

}  // namespace
}  // namespace cagewright
