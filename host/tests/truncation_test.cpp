// SPDX-License-Identifier: BSD-3-Clause
#include <string>

#include "host/file/byte_order.h"
#include "host/file/mesh_reader.h"
#include "host/file/mesh_writer.h"
#include "host/file/slides_file.h"
#include "host/tests/expect_file_error.h"
#include "host/tests/sample_meshes.h"

namespace cagewright::host {
namespace {

struct Sample {
  const char* name;
  MeshFile (*read)(const std::filesystem::path&, std::string_view);
  std::string bytes;
  // Bytes at the end without which nothing is missing: the last line's end, a name.
  std::size_t spare;
};

std::string binary_stl() {
  std::string bytes(80, ' ');
  append_little_endian(bytes, std::uint32_t{12});
  for (const auto& corners : corner_positions(unit_cube())) {
    bytes.append(12, '\0');
    for (const double x : corners) append_little_endian(bytes, static_cast<float>(x));
    bytes.append(2, '\0');
  }
  return bytes;
}

std::string binary_ply(const char* format, std::endian order) {
  const TriangleMesh cube = unit_cube();
  std::string bytes = "ply\nformat " + std::string(format) +
                      " 1.0\nelement vertex 8\nproperty double x\nproperty double y\nproperty double z\nelement face "
                      "12\nproperty list uchar uint vertex_indices\nend_header\n";
  const auto append = [&bytes, order](auto number) {
    std::string own;
    append_little_endian(own, number);
    bytes += order == std::endian::little ? own : std::string(own.rbegin(), own.rend());
  };
  for (const double x : cube.points) append(x);
  for (std::size_t i = 0; i < cube.triangles.size(); ++i) {
    if (i % 3 == 0) bytes += '\3';
    append(cube.triangles[i]);
  }
  return bytes;
}

MeshFile read_glb(const std::filesystem::path& path, std::string_view bytes) { return read_gltf(path, bytes); }

std::vector<Sample> samples() {
  const TriangleMesh cube = unit_cube();
  return {{"off", read_off, mesh_bytes(cube, "a.off"), 1},
          {"ply", read_ply, mesh_bytes(cube, "a.ply"), 1},
          {"stl", read_stl, mesh_bytes(cube, "a.stl"), std::string(" cagewright\n").size()},
          {"glb", read_glb, mesh_bytes(cube, "a.glb"), 0},
          {"binary stl", read_stl, binary_stl(), 0},
          {"little-endian ply", read_ply, binary_ply("binary_little_endian", std::endian::little), 0},
          {"big-endian ply", read_ply, binary_ply("binary_big_endian", std::endian::big), 0}};
}

TEST(Truncation, IsNoticedAtEveryByteOfFormatsThatPromiseTheirLength) {
  for (const Sample& sample : samples()) {
    EXPECT_EQ(corner_positions(sample.read("a", sample.bytes).mesh), corner_positions(unit_cube())) << sample.name;
    for (std::size_t length = 0; length < sample.bytes.size(); ++length) {
      // A copy of its own, so that a reader that looks beyond the end is caught by the sanitizers.
      const std::string cut(sample.bytes.substr(0, length));
      if (length + sample.spare >= sample.bytes.size()) {
        EXPECT_EQ(sample.read("a", cut).mesh.triangle_count(), 12u) << sample.name << " cut to " << length;
      } else {
        EXPECT_THROW(sample.read("a", cut), FileError) << sample.name << " cut to " << length;
      }
    }
  }
}

// OBJ promises nothing: a cut between lines is a smaller mesh. Within a line it must not invent another.
TEST(Truncation, OfObjGivesAnErrorOrTheFirstTriangles) {
  const TriangleMesh cube = unit_cube();
  const std::string bytes = mesh_bytes(cube, "a.obj");
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    try {
      const TriangleMesh mesh = read_obj("a", bytes.substr(0, length)).mesh;
      ASSERT_LE(mesh.triangles.size(), cube.triangles.size());
      EXPECT_TRUE(std::equal(mesh.triangles.begin(), mesh.triangles.end(), cube.triangles.begin())) << length;
    } catch (const FileError&) {
    }
  }
}

TEST(Truncation, OfSlidesIsAlwaysNoticed) {
  const std::string text = slides_text("a.json", {{"a", Slide::Stroke{{{1, 2, 3}, {4, 5, 6}}}},
                                                  {"b", Slide::PointNormal{{1, 2, 3}, {0, 0, 1}}},
                                                  {"p", Slide::Point{{1, 2, 3}}},
                                                  {"c", Slide::Ellipse{{1, 2, 3}, {1, 0, 0}, {0, 1, 0}}}});
  for (std::size_t length = 0; length + 1 < text.size(); ++length) {
    EXPECT_THROW(parse_slides("a.json", text.substr(0, length)), FileError) << length;
  }
}

// Any byte changed: an error or some mesh, but neither a crash nor indices out of range.
TEST(Damage, NeverGivesAMeshWithIndicesOutOfRange) {
  std::vector<Sample> all = samples();
  all.push_back({"obj", read_obj, mesh_bytes(unit_cube(), "a.obj"), 0});
  for (const Sample& sample : all) {
    for (std::size_t at = 0; at < sample.bytes.size(); ++at) {
      for (const char byte : {'\0', '\xFF', '9', '\n', '-'}) {
        std::string damaged = sample.bytes;
        damaged[at] = byte;
        try {
          const TriangleMesh mesh = sample.read("a", damaged).mesh;
          for (const std::uint32_t vertex : mesh.triangles) ASSERT_LT(vertex, mesh.vertex_count()) << sample.name << at;
        } catch (const FileError&) {
        }
      }
    }
  }
}

}  // namespace
}  // namespace cagewright::host
