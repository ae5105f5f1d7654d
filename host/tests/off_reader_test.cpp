// SPDX-License-Identifier: BSD-3-Clause
#include "host/file/mesh_reader.h"
#include "host/tests/expect_file_error.h"
#include "host/tests/sample_meshes.h"

namespace cagewright::host {
namespace {

TriangleMesh off(const std::string& text) { return read_off("a.off", text).mesh; }

const std::string body = "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";

TEST(OffReader, ReadsCountsOnTheFirstLineOrTheNext) {
  for (const std::string head : {"OFF\n3 1 0\n", "OFF 3 1 0\n", "OFF # a comment\n\n# more\n3 1 0\n", "3 1 0\n"}) {
    const TriangleMesh mesh = off(head + body);
    EXPECT_EQ(mesh.points, (Points{0, 0, 0, 1, 0, 0, 0, 1, 0})) << head;
    EXPECT_EQ(mesh.triangles, (Rows{0, 1, 2})) << head;
  }
}

TEST(OffReader, AcceptsAMissingNumberOfEdges) {
  for (const std::string head : {"OFF\n3 1\n", "OFF 3 1\n"}) EXPECT_EQ(off(head + body).triangle_count(), 1u);
}

TEST(OffReader, SkipsNormalsColoursAndTextureCoordinates) {
  const std::string coloured = "1 2 3 255 0 0 255\n4 5 6 255 0 0 255\n7 8 9 255 0 0 255\n3 0 1 2 0.5 0.5 0.5\n";
  for (const std::string keyword : {"COFF", "NOFF", "STOFF", "CNOFF", "STCNOFF", "OFF"}) {
    const TriangleMesh mesh = off(keyword + "\n3 1 0\n" + coloured);
    EXPECT_EQ(mesh.points, (Points{1, 2, 3, 4, 5, 6, 7, 8, 9})) << keyword;
    EXPECT_EQ(mesh.triangle_count(), 1u) << keyword;
  }
}

TEST(OffReader, ReadsElementsOverSeveralLines) {
  EXPECT_EQ(off("OFF 3 1 0\n0 0\n0\n1 0 0\n0 1 0\n3\n0 1\n2\n").triangle_count(), 1u);
}

TEST(OffReader, TurnsQuadsIntoTwoTriangles) {
  EXPECT_EQ(off("OFF 4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n").triangles, (Rows{0, 1, 2, 0, 2, 3}));
}

TEST(OffReader, KeepsWhatIsNotManifold) {
  EXPECT_EQ(
      off("OFF 4 5 0\n0 0 0\n1 0 0\n0 1 0\n9 9 9\n3 0 1 2\n3 0 1 2\n3 1 0 2\n3 0 0 1\n3 2 2 2\n").triangle_count(), 5u);
}

TEST(OffReader, NotesWhatFollowsTheLastFace) {
  const MeshFile file = read_off("a.off", "OFF 3 1 0\n" + body + "3 2 1 0\n");
  ASSERT_EQ(file.notes.size(), 1u);
  EXPECT_NE(file.notes[0].find("a.off, line 6: what follows the last of 1 face"), std::string::npos) << file.notes[0];
}

TEST(OffReader, NamesLineAndCulpritOfBadInput) {
  const auto expect = [](const std::string& text, const std::vector<std::string>& parts) {
    SCOPED_TRACE(text);
    expect_file_error([&] { off(text); }, parts);
  };
  expect("hello\n", {"a.off, line 1", "is not OFF", "hello"});
  expect("XOFF\n3 1 0\n", {"line 1", "XOFF"});
  expect("4OFF\n3 1 0\n", {"line 1", "4OFF"});
  expect("nOFF\n3 1 0\n", {"line 1", "nOFF"});
  expect("OFF BINARY\n", {"line 1", "binary"});
  expect("OFF\n", {"the number of vertices"});
  expect("OFF 3\n", {"the number of faces"});
  expect("OFF 3 x 0\n", {"line 1", "the number of faces", "\"x\""});
  expect("OFF -3 1 0\n", {"line 1", "negative"});
  expect("OFF 3 1 0 7\n", {"line 1", "\"7\""});
  expect("OFF 4000000000 4000000000 0\n0 0 0\n", {"line 1", "4000000000", "more than the file can hold"});
  expect("OFF 3 1 0\n0 0 0\n1 0 0\n", {"the file ends after 2 vertices of 3"});
  expect("OFF 3 2 0\n" + body, {"the file ends after 1 face of 2"});
  expect("OFF 3 1 0\n0 0 0\n1 nan 0\n", {"line 3", "vertex 1", "not finite"});
  expect("OFF 3 1 0\n0 0 0\n1 x 0\n", {"line 3", "vertex 1", "\"x\""});
  expect("OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", {"line 5", "face 0", "vertex 3", "3 vertices"});
  expect("OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n", {"line 5", "face 0", "vertex -1"});
  expect("OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n2 0 1\n", {"line 5", "face 0", "2 corners"});
  expect("OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 red\n", {"line 5", "face 0", "red"});
  expect("OFF 3 0 0\n0 0 0\n1 0 0\n0 1 0\n", {"a.off", "3 vertices", "no triangles"});
  expect("OFF 0 0 0\n", {"a.off", "is not a mesh"});
}

}  // namespace
}  // namespace cagewright::host
