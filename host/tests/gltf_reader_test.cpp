// SPDX-License-Identifier: BSD-3-Clause
#include <limits>

#include "host/file/mesh_reader.h"
#include "host/tests/expect_file_error.h"
#include "host/tests/glb_sample.h"
#include "host/tests/sample_meshes.h"
#include "host/tests/temporary_folder.h"

namespace cagewright::host {
namespace {

using nlohmann::json;

const std::vector<float> four_points = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0};

MeshFile glb(const GlbSample& sample) { return read_gltf("a.glb", sample.bytes()); }

// Strip or fan over four_points, with or without indices.
Rows triangles_of(int mode, const std::vector<std::uint8_t>& indices) {
  GlbSample sample;
  const int positions = sample.accessor(sample.view(four_points), gl_float, 4, "VEC3");
  const int count = static_cast<int>(indices.size());
  sample.node(
      sample.mesh(positions, count > 0 ? sample.accessor(sample.view(indices), gl_ubyte, count, "SCALAR") : -1, mode));
  return glb(sample).mesh.triangles;
}

TEST(GltfReader, ReadsIndicesOfEveryType) {
  for (const int type : {gl_ubyte, gl_ushort, gl_uint}) {
    GlbSample sample;
    const int positions = sample.accessor(sample.view(four_points), gl_float, 4, "VEC3");
    const int view = type == gl_ubyte    ? sample.view<std::uint8_t>({3, 2, 1})
                     : type == gl_ushort ? sample.view<std::uint16_t>({3, 2, 1})
                                         : sample.view<std::uint32_t>({3, 2, 1});
    sample.node(sample.mesh(positions, sample.accessor(view, type, 3, "SCALAR")));
    EXPECT_EQ(glb(sample).mesh.triangles, (Rows{3, 2, 1}));
    EXPECT_EQ(glb(sample).mesh.vertex_count(), 4u);
  }
}

TEST(GltfReader, ReadsTrianglesWithoutIndices) {
  GlbSample sample;
  sample.node(sample.mesh(sample.accessor(sample.view(four_points), gl_float, 3, "VEC3"), -1));
  EXPECT_EQ(glb(sample).mesh.triangles, (Rows{0, 1, 2}));
}

TEST(GltfReader, UnrollsStripsAndFansInOneDirection) {
  EXPECT_EQ(triangles_of(5, {}), (Rows{0, 1, 2, 1, 3, 2}));
  EXPECT_EQ(triangles_of(6, {}), (Rows{1, 2, 0, 2, 3, 0}));
  EXPECT_EQ(triangles_of(5, {3, 2, 1, 0}), (Rows{3, 2, 1, 2, 0, 1}));
  EXPECT_EQ(triangles_of(5, {0, 1, 2, 2, 3}), (Rows{0, 1, 2}));
}

TEST(GltfReader, KeepsDegenerateTriangles) { EXPECT_EQ(triangles_of(4, {0, 0, 1, 2, 1, 0}), (Rows{0, 0, 1, 2, 1, 0})); }

TEST(GltfReader, FollowsStrides) {
  GlbSample sample;
  const int view = sample.view<float>({0, 0, 0, 9, 9, 1, 0, 0, 9, 9, 0, 1, 0, 9, 9}, 20);
  sample.node(sample.mesh(sample.accessor(view, gl_float, 3, "VEC3"), -1));
  EXPECT_EQ(glb(sample).mesh.points, (Points{0, 0, 0, 1, 0, 0, 0, 1, 0}));
}

TEST(GltfReader, DecodesIntegerAndNormalisedPositions) {
  GlbSample sample;
  const int view = sample.view<std::int16_t>({32767, 0, -32768, 0, -32767, 0, 0, 0, 0, 32767, 0, 0}, 8);
  const int accessor = sample.accessor(view, gl_short, 3, "VEC3");
  sample.node(sample.mesh(accessor, -1));
  EXPECT_EQ(glb(sample).mesh.points, (Points{32767, 0, -32768, -32767, 0, 0, 0, 32767, 0}));
  sample.json["accessors"][static_cast<std::size_t>(accessor)]["normalized"] = true;
  EXPECT_EQ(glb(sample).mesh.points, (Points{1, 0, -1, -1, 0, 0, 0, 1, 0}));
}

TEST(GltfReader, DecodesSparseAccessorsWithAndWithoutBase) {
  GlbSample sample;
  const int positions = sample.accessor(sample.view(four_points), gl_float, 3, "VEC3");
  const int rows = sample.view<std::uint8_t>({1, 2});
  const int values = sample.view<float>({5, 6, 7, 8, 9, 10});
  auto& accessor = sample.json["accessors"][static_cast<std::size_t>(positions)];
  accessor["sparse"] = {{"count", 2},
                        {"indices", {{"bufferView", rows}, {"componentType", gl_ubyte}}},
                        {"values", {{"bufferView", values}}}};
  sample.node(sample.mesh(positions, -1));
  EXPECT_EQ(glb(sample).mesh.points, (Points{0, 0, 0, 5, 6, 7, 8, 9, 10}));
  sample.json["accessors"][static_cast<std::size_t>(positions)].erase("bufferView");
  EXPECT_EQ(glb(sample).mesh.points, (Points{0, 0, 0, 5, 6, 7, 8, 9, 10}));
}

TEST(GltfReader, LeavesASingleMeshInItsLocalSpace) {
  GlbSample sample;
  sample.one_triangle();
  sample.json["nodes"][0]["translation"] = {10, 20, 30};
  const MeshFile file = glb(sample);
  EXPECT_EQ(file.mesh.points, (Points{0, 0, 0, 1, 0, 0, 0, 1, 0}));
  EXPECT_TRUE(file.notes.empty());
}

TEST(GltfReader, MergesSeveralMeshesInTheScenesSpaceAndSaysSo) {
  GlbSample sample;
  sample.one_triangle();
  sample.json["nodes"] = {
      {{"children", {1, 2}}, {"translation", {10, 0, 0}}},
      {{"mesh", 0}, {"scale", {2, 2, 2}}, {"rotation", {0, 0, 0.7071067811865476, 0.7071067811865476}}},
      {{"mesh", 0}, {"matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 5, 1}}}};
  const MeshFile file = glb(sample);
  const Points expected = {10, 0, 0, 10, 2, 0, 8, 0, 0, 10, 0, 5, 11, 0, 5, 10, 1, 5};
  ASSERT_EQ(file.mesh.points.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(file.mesh.points[i], expected[i], 1e-12) << i;
  EXPECT_EQ(file.mesh.triangles, (Rows{0, 1, 2, 3, 4, 5}));
  ASSERT_EQ(file.notes.size(), 1u);
  EXPECT_NE(file.notes[0].find("a.glb: 2 mesh nodes were merged"), std::string::npos) << file.notes[0];
}

TEST(GltfReader, TurnsTrianglesThatATransformMirrors) {
  GlbSample sample;
  sample.one_triangle();
  sample.node(0);
  sample.json["nodes"][1]["scale"] = {-1, 1, 1};
  EXPECT_EQ(glb(sample).mesh.triangles, (Rows{0, 1, 2, 3, 5, 4}));
}

TEST(GltfReader, ReadsOnlyTheDefaultScene) {
  GlbSample sample;
  sample.one_triangle();
  sample.json["nodes"].push_back({{"mesh", 0}});
  EXPECT_EQ(glb(sample).mesh.triangle_count(), 1u);
  sample.json.erase("scene");
  EXPECT_EQ(glb(sample).mesh.triangle_count(), 1u);
  sample.json.erase("scenes");
  EXPECT_EQ(glb(sample).mesh.triangle_count(), 2u);
}

TEST(GltfReader, SharesThePositionsOfPrimitivesThatShareTheirAccessor) {
  GlbSample sample;
  sample.one_triangle();
  auto& primitives = sample.json["meshes"][0]["primitives"];
  primitives.push_back(primitives[0]);
  EXPECT_EQ(glb(sample).mesh.vertex_count(), 3u);
  EXPECT_EQ(glb(sample).mesh.triangles, (Rows{0, 1, 2, 0, 1, 2}));
}

TEST(GltfReader, NotesPrimitivesWithoutTriangles) {
  GlbSample sample;
  sample.one_triangle();
  auto& primitives = sample.json["meshes"][0]["primitives"];
  primitives.push_back(primitives[0]);
  primitives[1]["mode"] = 1;
  const MeshFile file = glb(sample);
  ASSERT_EQ(file.notes.size(), 1u);
  EXPECT_NE(file.notes[0].find("a.glb: mesh 0: 1 primitive without triangles"), std::string::npos) << file.notes[0];
}

TEST(GltfReader, FindsBuffersBesideTheFileAndNowhereElse) {
  const TemporaryFolder folder;
  GlbSample sample;
  sample.one_triangle();
  const std::string whole = sample.bytes();
  json document = sample.json;
  const std::string binary = whole.substr(whole.find(std::string("BIN\0", 4)) + 4);
  document["buffers"] = {{{"byteLength", binary.size()}, {"uri", "two%20words.bin"}}};
  const std::filesystem::path path = folder.write("a.gltf", document.dump());
  expect_file_error([&] { read_mesh(path); }, {"a.gltf", "two words.bin"});
  folder.write("two words.bin", binary);
  EXPECT_EQ(read_mesh(path).mesh.triangles, (Rows{0, 1, 2}));
  folder.write("two words.bin", binary.substr(1));
  expect_file_error([&] { read_mesh(path); }, {"a.gltf", "two words.bin"});
}

TEST(GltfReader, DoesNotNeedItsImages) {
  GlbSample sample;
  sample.one_triangle();
  sample.json["images"] = {{{"uri", "missing.png"}}, {{"uri", "data:image/png;base64,AAAA"}}};
  EXPECT_EQ(glb(sample).mesh.triangle_count(), 1u);
}

TEST(GltfReader, DeepNodesDoNotOverflowTheStack) {
  GlbSample sample;
  sample.one_triangle();
  for (int i = 1; i < 100000; ++i) {
    sample.json["nodes"].push_back({{"children", {i - 1}}});
  }
  sample.json["scenes"][0]["nodes"] = {99999};
  EXPECT_EQ(glb(sample).mesh.triangle_count(), 1u);
}

}  // namespace
}  // namespace cagewright::host
