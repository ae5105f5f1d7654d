// SPDX-License-Identifier: BSD-3-Clause
#include <clocale>

#include "host/file/mesh_reader.h"
#include "host/tests/expect_file_error.h"
#include "host/tests/sample_meshes.h"

namespace cagewright::host {
namespace {

TriangleMesh obj(const std::string& text) { return read_obj("a.obj", text).mesh; }

const std::string three_vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

TEST(ObjReader, ReadsVerticesAndTriangles) {
  const TriangleMesh mesh = obj("# a comment\nv 0.5 -1e-3 +7\nv 1 0 0 # another\nv 0 1 0\n\nf 1 2 3\n");
  EXPECT_EQ(mesh.points, (Points{0.5, -1e-3, 7, 1, 0, 0, 0, 1, 0}));
  EXPECT_EQ(mesh.triangles, (Rows{0, 1, 2}));
}

TEST(ObjReader, KeepsFacesThatAreNotManifold) {
  const TriangleMesh mesh = obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 0 -1\nf 1 2 3\nf 1 2 4\nf 1 2 5\nf 1 2 5\n");
  EXPECT_EQ(mesh.triangle_count(), 4u);
}

TEST(ObjReader, KeepsDegenerateFacesAndUnusedVertices) {
  const TriangleMesh mesh = obj(three_vertices + "v 9 9 9\nf 1 1 2\nf 2 2 2\n");
  EXPECT_EQ(mesh.vertex_count(), 4u);
  EXPECT_EQ(mesh.triangles, (Rows{0, 0, 1, 1, 1, 1}));
}

TEST(ObjReader, CountsNegativeIndicesFromTheLastVertexSoFar) {
  EXPECT_EQ(obj(three_vertices + "f -3 -2 -1\nv 5 5 5\nf -1 -2 -3\n").triangles, (Rows{0, 1, 2, 3, 2, 1}));
}

TEST(ObjReader, TakesTheVertexOfEveryKindOfCorner) {
  EXPECT_EQ(obj(three_vertices + "vt 0 0\nvn 0 0 1\nf 1/1 2//1 3/1/1\nf -3/-1/-1 2/ 3\n").triangles,
            (Rows{0, 1, 2, 0, 1, 2}));
}

TEST(ObjReader, SkipsWeightsAndColoursOfVertices) {
  const TriangleMesh mesh = obj("v 1 2 3 1\nv 4 5 6 0.1 0.2 0.3\nv 7 8 9 1 0.1 0.2 0.3\nf 1 2 3\n");
  EXPECT_EQ(mesh.points, (Points{1, 2, 3, 4, 5, 6, 7, 8, 9}));
}

TEST(ObjReader, JoinsContinuedLines) {
  const TriangleMesh mesh = obj("v 0 \\\n 0 0\nv 1 0 0\r\nv 0 1 0\nf 1 \\\r\n 2 3\n");
  EXPECT_EQ(mesh.vertex_count(), 3u);
  EXPECT_EQ(mesh.triangles, (Rows{0, 1, 2}));
}

TEST(ObjReader, ReadsEveryKindOfLineEndAndAByteOrderMark) {
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    const TriangleMesh mesh = obj("\xEF\xBB\xBFv 0 0 0" + end + "v 1 0 0" + end + "v 0 1 0" + end + "f 1 2 3");
    EXPECT_EQ(mesh.vertex_count(), 3u);
    EXPECT_EQ(mesh.triangle_count(), 1u);
  }
}

TEST(ObjReader, AcceptsFacesBeforeTheirVertices) {
  EXPECT_EQ(obj("f 1 2 3\n" + three_vertices).triangles, (Rows{0, 1, 2}));
}

TEST(ObjReader, SkipsWhatSaysNothingAboutPolygons) {
  EXPECT_EQ(
      obj("mtllib a.mtl\no x\ng a b\ns off\nusemtl red\n" + three_vertices + "l 1 2\np 1\nf 1 2 3\n").triangle_count(),
      1u);
}

TEST(ObjReader, NotesFreeFormCurves) {
  const MeshFile file = read_obj("a.obj", three_vertices + "cstype bezier\ncurv 0 1 1 2 3\nend\nf 1 2 3\n");
  ASSERT_EQ(file.notes.size(), 1u);
  EXPECT_NE(file.notes[0].find("a.obj: 1 free-form curve"), std::string::npos) << file.notes[0];
}

TEST(ObjReader, DoesNotDependOnTheLocale) {
  const char* german = std::setlocale(LC_ALL, "de_DE.UTF-8");
  const TriangleMesh mesh = obj("v 0.5 1.25 2\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  if (german != nullptr) std::setlocale(LC_ALL, "C");
  EXPECT_EQ(mesh.points[1], 1.25);
}

TEST(ObjReader, NumbersTooSmallForADoubleAreZero) {
  EXPECT_EQ(obj("v 1e-999 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").points[0], 0);
}

TEST(ObjReader, NamesLineAndCulpritOfBadInput) {
  const auto expect = [](const std::string& text, const std::vector<std::string>& parts) {
    SCOPED_TRACE(text);
    expect_file_error([&] { obj(text); }, parts);
  };
  expect(three_vertices + "f 1 2 99\n", {"a.obj, line 4", "face 1", "vertex 99", "3 vertices"});
  expect("f 1 2 7\n" + three_vertices, {"a.obj, line 1", "vertex 7", "3 vertices"});
  expect(three_vertices + "f 0 1 2\n", {"line 4", "vertex 0"});
  expect(three_vertices + "f 1 2 -4\n", {"line 4", "vertex -4"});
  expect(three_vertices + "f 1 2 99999999999999999999\n", {"line 4", "99999999999999999999"});
  expect(three_vertices + "f 1 2 4294967297\n", {"line 4", "4294967297"});
  expect(three_vertices + "f 1 2\n", {"line 4", "face 1", "2 corners"});
  expect(three_vertices + "f 1 2 x\n", {"line 4", "\"x\""});
  expect(three_vertices + "f 1 2 /3\n", {"line 4", "\"/3\""});
  expect("v 0 nan 0\n", {"line 1", "y of a vertex", "not finite", "nan"});
  expect("v 0 0 -inf\n", {"line 1", "z of a vertex", "not finite"});
  expect("v 1e999 0 0\n", {"line 1", "x of a vertex", "not finite", "1e999"});
  expect("v 0 0\n", {"line 1", "ends where the z"});
  expect("v 0 0 zero\n", {"line 1", "z of a vertex", "\"zero\""});
  expect("v 1 2 3 4 5 6 7 8\n", {"line 1", "more than 7"});
  expect("<html>\n", {"line 1", "is not OBJ", "<html>"});
  expect(std::string("\x01\x02\x00\xFF", 4), {"line 1", "is not OBJ", "\"????\""});
  expect(three_vertices, {"a.obj", "3 vertices", "no triangles"});
  expect("# nothing\n", {"a.obj", "is not a mesh"});
}

}  // namespace
}  // namespace cagewright::host
