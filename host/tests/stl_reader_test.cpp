// SPDX-License-Identifier: BSD-3-Clause
#include <limits>

#include "host/file/byte_order.h"
#include "host/file/mesh_reader.h"
#include "host/tests/expect_file_error.h"
#include "host/tests/sample_meshes.h"

namespace cagewright::host {
namespace {

TriangleMesh stl(const std::string& bytes) { return read_stl("a.stl", bytes).mesh; }

std::string facet(const std::string& a, const std::string& b, const std::string& c) {
  return "facet normal 0 0 1\n outer loop\n  vertex " + a + "\n  vertex " + b + "\n  vertex " + c +
         "\n endloop\nendfacet\n";
}

std::string binary(const TriangleMesh& mesh, std::string head = "") {
  head.resize(80, ' ');
  append_little_endian(head, static_cast<std::uint32_t>(mesh.triangle_count()));
  for (const auto& corners : corner_positions(mesh)) {
    head.append(12, '\0');
    for (const double x : corners) append_little_endian(head, static_cast<float>(x));
    head.append(2, '\0');
  }
  return head;
}

TEST(StlReader, ReadsAsciiAndWeldsCornersAtTheSamePosition) {
  const TriangleMesh mesh = stl("solid two words\n" + facet("0 0 0", "1 0 0", "0 1 0") +
                                facet("1 0 0", "1 1 0", "0 1 -0") + "endsolid two words\n");
  EXPECT_EQ(mesh.vertex_count(), 4u);
  EXPECT_EQ(mesh.triangles, (Rows{0, 1, 2, 1, 3, 2}));
}

TEST(StlReader, DoesNotWeldWhatIsMerelyNear) {
  EXPECT_EQ(stl("solid\n" + facet("0 0 0", "1 0 0", "0 1 0") + facet("1e-300 0 0", "1 0 0", "0 1 0") + "endsolid\n")
                .vertex_count(),
            4u);
}

TEST(StlReader, ReadsSeveralSolids) {
  const std::string solid = "solid\n" + facet("0 0 0", "1 0 0", "0 1 0") + "endsolid\n";
  EXPECT_EQ(stl(solid + solid).triangle_count(), 2u);
}

TEST(StlReader, ReadsBinaryEvenWhereItBeginsWithSolid) {
  for (const std::string head : {"made by hand", "solid thing"}) {
    const TriangleMesh mesh = stl(binary(unit_cube(), head));
    EXPECT_EQ(mesh.vertex_count(), 8u);
    EXPECT_EQ(corner_positions(mesh), corner_positions(unit_cube()));
  }
}

TEST(StlReader, KeepsDegenerateAndRepeatedTriangles) {
  EXPECT_EQ(stl("solid\n" + facet("0 0 0", "0 0 0", "0 1 0") + facet("0 0 0", "0 0 0", "0 1 0") + "endsolid\n")
                .triangle_count(),
            2u);
}

TEST(StlReader, NamesPlaceAndCulpritOfBadInput) {
  const auto expect = [](const std::string& bytes, const std::vector<std::string>& parts) {
    SCOPED_TRACE(bytes.substr(0, 100));
    expect_file_error([&] { stl(bytes); }, parts);
  };
  expect("hello", {"a.stl", "is not STL"});
  expect("solid\n" + facet("0 0 0", "1 0 0", "0 1 0"), {"a.stl", "endsolid"});
  expect("solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 0 0\nvertex 1 1 1\n",
         {"line 6", "triangle 0", "vertex"});
  expect("solid\n" + facet("0 0 0", "1 nan 0", "0 1 0"), {"line 5", "triangle 0", "not finite"});
  expect("solid\nfacet normal 0 0 1\nouter loop\nendloop\n", {"line 4", "\"vertex\"", "\"endloop\""});
  expect("solid\nsurface\n", {"line 2", "surface"});
  expect("solid\nendsolid\n", {"a.stl", "no triangles"});
  expect(binary(unit_cube()) + "x", {"a.stl, byte 80", "12 triangles", "684 bytes", "685"});
  expect(binary(unit_cube()).substr(0, 600), {"byte 80", "684 bytes", "600"});
  expect(binary({}), {"a.stl", "no triangles"});
  TriangleMesh infinite = unit_cube();
  infinite.points[3] = std::numeric_limits<double>::infinity();
  expect(binary(infinite), {"byte 120", "triangle 0", "not finite"});
}

}  // namespace
}  // namespace cagewright::host
