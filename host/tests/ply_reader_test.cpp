// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "host/file/byte_order.h"
#include "host/file/mesh_reader.h"
#include "host/tests/expect_file_error.h"
#include "host/tests/sample_meshes.h"

namespace cagewright::host {
namespace {

TriangleMesh ply(const std::string& bytes) { return read_ply("a.ply", bytes).mesh; }

std::string header(const std::string& format, int vertices, int faces) {
  return "ply\nformat " + format + " 1.0\ncomment made by hand\nobj_info x\nelement vertex " +
         std::to_string(vertices) + "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
         std::to_string(faces) + "\nproperty list uchar int vertex_indices\nend_header\n";
}

const std::string ascii_body = "0 0 0\n1 0 0\n0 1.5 0\n3 0 1 2\n";

template <class Number>
void append(std::string& bytes, Number number, std::endian order) {
  std::string own;
  append_little_endian(own, number);
  if (order == std::endian::big) std::reverse(own.begin(), own.end());
  bytes += own;
}

std::string binary_body(std::endian order) {
  std::string bytes;
  for (const float x : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.5f, 0.f}) append(bytes, x, order);
  bytes += '\3';
  for (const std::int32_t i : {0, 1, 2}) append(bytes, i, order);
  return bytes;
}

TEST(PlyReader, ReadsAsciiAndBothBinaryFormats) {
  for (const std::string& bytes :
       {header("ascii", 3, 1) + ascii_body, header("binary_little_endian", 3, 1) + binary_body(std::endian::little),
        header("binary_big_endian", 3, 1) + binary_body(std::endian::big)}) {
    const TriangleMesh mesh = ply(bytes);
    EXPECT_EQ(mesh.points, (Points{0, 0, 0, 1, 0, 0, 0, 1.5, 0}));
    EXPECT_EQ(mesh.triangles, (Rows{0, 1, 2}));
  }
}

TEST(PlyReader, ReadsAHeaderWithWindowsLineEnds) {
  const std::string head = header("binary_little_endian", 3, 1);
  std::string windows_head;
  for (const char c : head) windows_head += c == '\n' ? std::string("\r\n") : std::string(1, c);
  EXPECT_EQ(ply(windows_head + binary_body(std::endian::little)).triangle_count(), 1u);
}

TEST(PlyReader, ReadsEveryTypeAndSkipsOtherPropertiesAndElements) {
  std::string bytes =
      "ply\nformat binary_little_endian 1.0\nelement camera 1\nproperty double f\nproperty list uint16 int16 odd\n"
      "element vertex 3\nproperty uchar red\nproperty double x\nproperty int16 y\nproperty uint32 z\n"
      "element face 1\nproperty int8 flag\nproperty list int32 uint16 vertex_index\nproperty list uchar float "
      "uv\nend_header\n";
  append_little_endian(bytes, 2.5);
  append_little_endian(bytes, std::uint16_t{2});
  bytes += "abcd";
  for (int i = 0; i < 3; ++i) {
    bytes += 'r';
    append_little_endian(bytes, 0.1 + i);
    append_little_endian(bytes, static_cast<std::int16_t>(-i));
    append_little_endian(bytes, 4000000000u);
  }
  bytes += 'f';
  append_little_endian(bytes, std::int32_t{3});
  for (const int i : {2, 1, 0}) append_little_endian(bytes, static_cast<std::uint16_t>(i));
  bytes += '\1';
  append_little_endian(bytes, 1.0f);
  const MeshFile file = read_ply("a.ply", bytes);
  EXPECT_EQ(file.mesh.points, (Points{0.1, 0, 4e9, 1.1, -1, 4e9, 2.1, -2, 4e9}));
  EXPECT_EQ(file.mesh.triangles, (Rows{2, 1, 0}));
  EXPECT_TRUE(file.notes.empty());
}

TEST(PlyReader, AcceptsFacesBeforeVertices) {
  EXPECT_EQ(ply("ply\nformat ascii 1.0\nelement face 1\nproperty list uchar int vertex_indices\nelement vertex 3\n"
                "property float x\nproperty float y\nproperty float z\nend_header\n3 0 1 2\n0 0 0\n1 0 0\n0 1 0\n")
                .triangle_count(),
            1u);
}

TEST(PlyReader, ReadsTriangleStrips) {
  const std::string head =
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
      "element tristrips 1\nproperty list int int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n";
  EXPECT_EQ(ply(head + "8 0 1 2 3 -1 1 2 3\n").triangles, (Rows{0, 1, 2, 2, 1, 3, 1, 2, 3}));
  EXPECT_EQ(ply(head + "5 0 1 1 2 3\n").triangles, (Rows{1, 2, 3}));
}

TEST(PlyReader, KeepsWhatIsNotManifold) {
  EXPECT_EQ(ply(header("ascii", 3, 3) + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0 1 2\n3 0 0 0\n").triangle_count(), 3u);
}

TEST(PlyReader, NotesWhatFollowsTheLastElement) {
  EXPECT_EQ(read_ply("a.ply", header("ascii", 3, 1) + ascii_body + "more\n").notes.size(), 1u);
}

TEST(PlyReader, NamesPlaceAndCulpritOfBadInput) {
  const auto expect = [](const std::string& bytes, const std::vector<std::string>& parts) {
    SCOPED_TRACE(bytes);
    expect_file_error([&] { ply(bytes); }, parts);
  };
  const std::string head = header("ascii", 3, 1), binary = header("binary_little_endian", 3, 1);
  expect("solid\n", {"a.ply, line 1", "is not PLY"});
  expect("plywood\n", {"a.ply, line 1", "is not PLY"});
  expect("ply\nformat ascii 1.0\n", {"line 3", "end_header"});
  expect("ply\nformat utf8 1.0\n", {"line 2", "utf8"});
  expect("ply\nformat ascii 2.0\n", {"line 2", "2.0"});
  expect("ply\nelement vertex x\n", {"line 2", "element vertex 8"});
  expect("ply\nproperty float x\n", {"line 2", "before every element"});
  expect("ply\nelement vertex 3\nproperty real x\n", {"line 3", "\"real\""});
  expect("ply\nwhat\n", {"line 2", "what"});
  expect("ply\nend_header\n", {"no \"format\""});
  expect("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n0\n", {"no x, y and z"});
  expect("ply\nformat ascii 1.0\nelement face 1\nproperty int a\nend_header\n0\n", {"face", "vertex_indices"});
  expect(head + "0 0 0\n1 0 0\n", {"line 14", "ends before vertex 2"});
  expect(head + "0 0 0\n1 0\n", {"line 13", "z of vertex 1"});
  expect(head + "0 0 0\n1 0 0 0\n", {"line 13", "more values", "vertex 1"});
  expect(head + "0 0 0\n1 inf 0\n", {"line 13", "y of vertex 1", "not finite"});
  expect(head + "0 0 0\n1 up 0\n", {"line 13", "y of vertex 1", "\"up\""});
  expect(head + "0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", {"a.ply", "face 0", "vertex 3", "3 vertices"});
  expect(head + "0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n", {"line 15", "face 0", "-1"});
  expect(head + "0 0 0\n1 0 0\n0 1 0\n3 0 1 1.5\n", {"line 15", "face 0"});
  expect(head + "0 0 0\n1 0 0\n0 1 0\n2 0 1\n", {"line 15", "face 0", "2 corners"});
  expect(head + "0 0 0\n1 0 0\n0 1 0\n-3 0 1 2\n", {"line 15", "length of vertex_indices of face 0"});
  expect(header("ascii", 3, 0) + "0 0 0\n1 0 0\n0 1 0\n", {"no triangles"});
  expect(header("binary_little_endian", 2000000000, 1) + "abc", {"byte", "2000000000", "more than the file can hold"});
  std::string truncated = binary + binary_body(std::endian::little);
  truncated.pop_back();
  expect(truncated, {"byte", "vertex_indices of face 0"});
  std::string not_finite = binary + binary_body(std::endian::little);
  not_finite.replace(binary.size() + 4, 4, "\x00\x00\x80\x7F", 4);
  expect(not_finite, {"byte", "y of vertex 0", "not finite"});
}

}  // namespace
}  // namespace cagewright::host
