// SPDX-License-Identifier: BSD-3-Clause
#include "host/file/mesh_writer.h"

#include <clocale>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "host/file/byte_order.h"
#include "host/file/mesh_reader.h"
#include "host/tests/expect_file_error.h"
#include "host/tests/sample_meshes.h"

namespace cagewright::host {
namespace {

constexpr std::uint32_t trials = 200;

TEST(MeshWriter, EveryMeshComesBackBitForBitFromFormatsWithIndices) {
  for (std::uint32_t seed = 0; seed < trials; ++seed) {
    const TriangleMesh mesh = random_mesh(seed);
    for (const TriangleMesh& copy :
         {read_obj("a", mesh_bytes(mesh, "a.obj")).mesh, read_off("a", mesh_bytes(mesh, "a.off")).mesh,
          read_ply("a", mesh_bytes(mesh, "a.ply")).mesh}) {
      ASSERT_EQ(copy.points, mesh.points) << seed;
      ASSERT_EQ(copy.triangles, mesh.triangles) << seed;
    }
  }
}

TEST(MeshWriter, EveryCornerComesBackBitForBitFromStl) {
  for (std::uint32_t seed = 0; seed < trials; ++seed) {
    const TriangleMesh mesh = random_mesh(seed);
    ASSERT_EQ(corner_positions(read_stl("a", mesh_bytes(mesh, "a.stl")).mesh), corner_positions(mesh)) << seed;
  }
}

TEST(MeshWriter, EveryMeshComesBackFromGlbAsFloats) {
  for (std::uint32_t seed = 0; seed < trials; ++seed) {
    const TriangleMesh mesh = random_mesh(seed);
    std::vector<double> floats;
    for (const double x : mesh.points) floats.push_back(double{static_cast<float>(x)});
    const TriangleMesh copy = read_gltf("a.glb", mesh_bytes(mesh, "a.glb")).mesh;
    ASSERT_EQ(copy.points, floats) << seed;
    ASSERT_EQ(copy.triangles, mesh.triangles) << seed;
  }
}

TEST(MeshWriter, GlbHasWholeChunksAndTheExactBoundsOfItsPositions) {
  const std::string file = mesh_bytes({{0.1, 2, -3, 4, 5, 6, -7, 0, 9}, {0, 1, 2}}, "a.glb");
  const auto word = [&file](std::size_t at) { return load<std::uint32_t>(file.data() + at, std::endian::little); };
  ASSERT_EQ(word(8), file.size());
  ASSERT_EQ(word(12) % 4, 0u);
  ASSERT_EQ(word(20 + word(12)) % 4, 0u);
  ASSERT_EQ(28 + word(12) + word(20 + word(12)), file.size());
  const auto json = nlohmann::json::parse(file.substr(20, word(12)));
  EXPECT_EQ(json["accessors"][0]["min"].get<std::vector<float>>(), (std::vector<float>{-7, 0, -3}));
  EXPECT_EQ(json["accessors"][0]["max"].get<std::vector<float>>(), (std::vector<float>{4, 5, 9}));
  EXPECT_EQ(json["meshes"][0]["primitives"][0]["mode"], 4);
  EXPECT_EQ(json["asset"]["version"], "2.0");
}

// 65535 is no index of 16 bits: glTF keeps it for the restart of strips.
TEST(MeshWriter, GlbUsesLongIndicesWhereShortOnesDoNotReach) {
  for (const std::size_t vertices : {65535u, 65536u}) {
    const auto last = static_cast<std::uint32_t>(vertices - 1);
    const TriangleMesh mesh{std::vector<double>(3 * vertices, 1.5), {0, 1, last}};
    const std::string file = mesh_bytes(mesh, "a.glb");
    EXPECT_EQ(read_gltf("a.glb", file).mesh.triangles, mesh.triangles);
    const auto json =
        nlohmann::json::parse(file.substr(20, load<std::uint32_t>(file.data() + 12, std::endian::little)));
    EXPECT_EQ(json["accessors"][1]["componentType"], vertices == 65535 ? 5123 : 5125);
  }
}

TEST(MeshWriter, ForgetsNoDigitInAnyLocale) {
  const TriangleMesh mesh{{0.1 + 0.2, 1e-310, -1.7976931348623157e308, 1, 0, 0, 0, 1, 0}, {0, 1, 2}};
  const bool has_german = std::setlocale(LC_ALL, "de_DE.UTF-8") != nullptr;
  const std::string text = mesh_bytes(mesh, "a.obj");
  if (has_german) std::setlocale(LC_ALL, "C");
  EXPECT_EQ(text.substr(0, text.find('\n')), "v 0.30000000000000004 1e-310 -1.7976931348623157e+308");
  EXPECT_EQ(read_obj("a", text).mesh.points, mesh.points);
}

TEST(MeshWriter, StlNormalsAreUnitOrZeroAtAnyScale) {
  for (const double scale : {1e-150, 1.0, 1e150}) {
    const std::string text = mesh_bytes({{0, 0, 0, scale, 0, 0, 0, scale, 0}, {0, 1, 2, 0, 0, 1}}, "a.stl");
    EXPECT_NE(text.find("facet normal 0 0 1\n"), text.npos) << text;
    EXPECT_NE(text.find("facet normal 0 0 0\n"), text.npos) << text;
  }
}

TEST(MeshWriter, NamesTheFileThatCannotBeMade) {
  expect_file_error([] { mesh_bytes(unit_cube(), "a.fbx"); }, {"a.fbx", "cannot be written", ".obj"});
  expect_file_error([] { mesh_bytes({{0, 0, 0}, {}}, "a.obj"); }, {"a.obj", "no triangles"});
  expect_file_error([] { mesh_bytes({{0, 0, 0, 1e39, 0, 0}, {0, 1, 0}}, "a.glb"); }, {"a.glb", "vertex 1", "floats"});
}

}  // namespace
}  // namespace cagewright::host
