// SPDX-License-Identifier: BSD-3-Clause
#include <limits>

#include "host/file/byte_order.h"
#include "host/file/mesh_reader.h"
#include "host/tests/expect_file_error.h"
#include "host/tests/glb_sample.h"
#include "host/tests/sample_meshes.h"
#include "host/tests/temporary_folder.h"

namespace cagewright::host {
namespace {

using nlohmann::json;

// Changes the JSON of a .glb of one good triangle and expects the sentence.
template <class Change>
void expect_after(Change change, const std::vector<std::string>& parts) {
  GlbSample sample;
  sample.one_triangle();
  change(sample.json);
  SCOPED_TRACE(sample.json.dump());
  expect_file_error([&] { read_gltf("a.glb", sample.bytes()); }, parts);
}

TEST(GltfReaderErrors, NameTheNodeAtFault) {
  expect_after([](json& j) { j["nodes"][0]["children"] = {0}; }, {"a.glb", "no tree", "node 0"});
  expect_after([](json& j) { j["nodes"] = {{{"children", {1}}}, {{"children", {0}}}}; }, {"no tree"});
  expect_after(
      [](json& j) {
        j["nodes"] = {{{"children", {1}}}, {{"children", {0}}}};
        j.erase("scenes");
        j.erase("scene");
      },
      {"circle"});
  expect_after([](json& j) { j["nodes"][0]["children"] = {7}; },
               {"node 0", "\"children\" names item 7 of \"nodes\"", "ends with item 0"});
  expect_after([](json& j) { j["nodes"][0]["mesh"] = 7; }, {"node 0", "\"mesh\" names item 7 of \"meshes\""});
  expect_after([](json& j) { j["scene"] = 7; }, {"\"scene\" names item 7 of \"scenes\""});
  expect_after([](json& j) { j["nodes"][0]["scale"] = {1, 2}; }, {"node 0", "scale", "3 finite numbers"});
  expect_after([](json& j) { j["nodes"][0]["matrix"] = {1, 2}; }, {"node 0", "matrix", "16 finite numbers"});
}

TEST(GltfReaderErrors, NameMeshPrimitiveAndAccessorAtFault) {
  expect_after([](json& j) { j["meshes"][0]["primitives"][0]["attributes"]["POSITION"] = 7; },
               {"mesh 0, primitive 0", "\"POSITION\" names item 7 of \"accessors\""});
  expect_after(
      [](json& j) {
        j["meshes"][0]["name"] = "hat";
        j["accessors"][0]["type"] = "VEC2";
      },
      {"mesh 0 (\"hat\")", "accessor 0", "VEC3"});
  expect_after([](json& j) { j["accessors"][0]["count"] = 4; }, {"accessor 0", "does not fit"});
  expect_after([](json& j) { j["accessors"][0]["count"] = 9007199254740992; }, {"accessor 0", "does not fit"});
  expect_after([](json& j) { j["accessors"][0]["byteOffset"] = 4; }, {"accessor 0", "does not fit"});
  expect_after([](json& j) { j["bufferViews"][0]["byteLength"] = 1000; }, {"buffer view 0", "of buffer 0, which has"});
  expect_after([](json& j) { j["bufferViews"][0]["byteOffset"] = 1000; }, {"buffer view 0", "of buffer 0, which has"});
  expect_after([](json& j) { j["bufferViews"][0]["byteStride"] = 4; }, {"accessor 0", "overlap"});
  expect_after([](json& j) { j["bufferViews"][0]["buffer"] = 3; }, {"buffer view 0", "\"buffer\" names item 3"});
  expect_after([](json& j) { j["accessors"][0]["bufferView"] = 9; }, {"accessor 0", "\"bufferView\" names item 9"});
  expect_after([](json& j) { j["accessors"][0].erase("bufferView"); }, {"accessor 0", "no buffer view"});
  expect_after([](json& j) { j["accessors"][0]["componentType"] = 5124; },
               {"accessor 0", "\"componentType\" should be"});
  expect_after([](json& j) { j["accessors"][1]["componentType"] = gl_short; }, {"accessor 1", "unsigned"});
  expect_after([](json& j) { j["accessors"][1]["count"] = 2; }, {"primitive 0", "2 corners"});
  expect_after([](json& j) { j["accessors"][0]["count"] = 2; }, {"primitive 0", "index 2", "vertex 2", "2 vertices"});
  expect_after([](json& j) { j["meshes"][0]["primitives"][0]["mode"] = 0; }, {"a.glb", "no triangles"});
  expect_after([](json& j) { j["meshes"][0]["primitives"] = json::array(); }, {"a.glb", "no triangles"});
  expect_after(
      [](json& j) {
        j["accessors"][0].erase("bufferView");
        j["accessors"][0]["count"] = 1000000000000;
        j["accessors"][0]["sparse"] = {{"count", 1},
                                       {"indices", {{"bufferView", 1}, {"componentType", gl_ushort}}},
                                       {"values", {{"bufferView", 0}}}};
      },
      {"accessor 0", "too many"});
  expect_after(
      [](json& j) {
        j["accessors"][0]["sparse"] = {
            {"count", 1},
            {"indices", {{"bufferView", 1}, {"byteOffset", 4}, {"componentType", gl_ushort}}},
            {"values", {{"bufferView", 0}}}};
        j["accessors"][0]["count"] = 2;
      },
      {"accessor 0", "sparse index 2"});
}

TEST(GltfReaderErrors, NameTheVertexThatIsNotFinite) {
  GlbSample sample;
  const float infinity = std::numeric_limits<float>::infinity();
  sample.node(
      sample.mesh(sample.accessor(sample.view<float>({0, 0, 0, 1, infinity, 0, 0, 1, 0}), gl_float, 3, "VEC3"), -1));
  expect_file_error([&] { read_gltf("a.glb", sample.bytes()); },
                    {"a.glb", "mesh 0, primitive 0", "vertex 1", "not finite"});
}

TEST(GltfReaderErrors, NameThePlaceWhereTheJsonIsBroken) {
  const auto expect = [](const std::string& bytes, std::vector<std::string> parts) {
    SCOPED_TRACE(bytes.substr(0, 60));
    parts.emplace_back("its JSON");
    expect_file_error([&] { read_gltf("a.glb", bytes); }, parts);
    try {
      read_gltf("a.glb", bytes);
    } catch (const FileError& error) {
      EXPECT_EQ(std::string(error.what()).find("json.exception"), std::string::npos) << error.what();
    }
  };
  GlbSample sample;
  sample.one_triangle();
  std::string broken = sample.bytes();
  const std::size_t colon = broken.find(':');
  broken[colon] = '\x01';
  expect(broken, {"a.glb, byte " + std::to_string(colon) + ": ", "broken at \"?"});
  broken = sample.bytes();
  broken[broken.find_last_of('}')] = ' ';  // the JSON is padded to four bytes, or not
  expect(broken, {"a.glb, byte ", "ends in the middle", "export it again"});
  expect("{\n \"asset\": {\"version\": \"2.0\"},\n  oops}", {"a.glb, line 3, column 3: ", "broken at \"oops}\""});
  expect("{\"asset\": {\"version\": \"2.0\"", {"line 1", "ends in the middle"});
}

TEST(GltfReaderErrors, NameTheNumberBeyondTheRangeOfDoubles) {
  expect_file_error([] { read_gltf("a.gltf", "{\"asset\":\n {\"version\": 1e999}}"); },
                    {"a.gltf, line 2, column 14: ", "range of doubles", "\"1e999\""});
}

TEST(GltfReaderErrors, NameTheChunkThatIsNotAsTheHeaderSays) {
  GlbSample sample;
  sample.one_triangle();
  std::string long_chunk = sample.bytes(), other_chunk = sample.bytes();
  long_chunk[14] = 1;  // adds 65536
  other_chunk.replace(16, 4, "JSOM");
  expect_file_error([&] { read_gltf("a.glb", long_chunk); }, {"a.glb, byte 12: ", "its JSON should have", "follow"});
  expect_file_error([&] { read_gltf("a.glb", other_chunk); }, {"a.glb, byte 16: ", "first chunk", "JSON"});
}

TEST(GltfReaderErrors, NameTheBufferFileThatIsMissingAndTheFileThatNamesIt) {
  const TemporaryFolder folder;
  GlbSample sample;
  sample.one_triangle();
  sample.json["buffers"][0] = {{"uri", "no%20such.bin"}, {"byteLength", 44}};
  folder.write("a.gltf", sample.json.dump());
  expect_file_error([&] { read_mesh(folder / "a.gltf"); },
                    {(folder / "a.gltf").string() + ": ", "file \"no such.bin\"", "put it there", ".glb"});
}

TEST(GltfReaderErrors, SayThatCompressionIsNotSupported) {
  expect_after([](json& j) { j["extensionsRequired"] = {"KHR_draco_mesh_compression"}; }, {"a.glb", "Draco"});
  expect_after([](json& j) { j["extensionsRequired"] = {"EXT_meshopt_compression"}; }, {"a.glb", "meshopt"});
  expect_after(
      [](json& j) {
        j["meshes"][0]["primitives"][0]["extensions"]["KHR_draco_mesh_compression"] = {{"bufferView", 0}};
        j["accessors"][0].erase("bufferView");
      },
      {"a.glb", "mesh 0, primitive 0", "Draco"});
}

TEST(GltfReaderErrors, SayWhatIsNotGltf) {
  const auto expect = [](const std::string& bytes, const std::vector<std::string>& parts) {
    SCOPED_TRACE(bytes.substr(0, 60));
    expect_file_error([&] { read_gltf("a.gltf", bytes); }, parts);
  };
  expect("hello there", {"a.gltf, line 1, column 1: ", "its JSON is broken at \"hello there\""});
  expect("[1, 2, 3]", {"a.gltf", "object"});
  expect("{}  ", {"a.gltf", "asset"});
  expect("{\"asset\": {\"version\": \"1.0\"}}", {"a.gltf", "1.0", "only 2.0"});
  expect(std::string(300, '[') + std::string(300, ']'), {"a.gltf", "too deeply"});
  expect("glTF", {"a.gltf", "cut short"});
  GlbSample sample;
  sample.one_triangle();
  std::string old = sample.bytes();
  old[4] = 1;
  expect(old, {"a.gltf", "\"1.0\"", "only 2.0"});
}

}  // namespace
}  // namespace cagewright::host
