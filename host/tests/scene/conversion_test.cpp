// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "host/command/cage_commands.h"
#include "host/command/command_stack.h"
#include "host/file/file_bytes.h"
#include "host/file/gltf_container.h"
#include "host/scene/external_files.h"
#include "host/tests/expect_file_error.h"
#include "host/tests/scene/edited_scene.h"
#include "host/tests/scene/scene_files.h"
#include "host/tests/temporary_folder.h"

namespace cagewright::host::test {
namespace {

using Copies = std::vector<std::pair<std::filesystem::path, std::string>>;

std::string binary_of(const SceneDocument& scene) {
  const std::string bytes = scene.bytes();
  return std::string(split_gltf(scene.path(), bytes).binary);
}

void expect_same_meshes(const SceneDocument& a, const SceneDocument& b) {
  ASSERT_EQ(a.mesh_nodes().size(), b.mesh_nodes().size());
  for (const SceneMeshNode& node : a.mesh_nodes()) {
    const TriangleMesh one = a.mesh(node.node).mesh, other = b.mesh(node.node).mesh;
    EXPECT_EQ(one.points, other.points) << node.node;
    EXPECT_EQ(one.triangles, other.triangles) << node.node;
  }
  ASSERT_EQ(a.cages().size(), b.cages().size());
  for (const SceneCage& cage : a.cages()) {
    EXPECT_EQ(cage.mesh.points, b.find_cage(cage.mesh_node)->mesh.points);
    EXPECT_EQ(cage.certificate, b.find_cage(cage.mesh_node)->certificate);
  }
  ASSERT_EQ(a.slides().size(), b.slides().size());
  for (const SceneSlide& slide : a.slides()) {
    expect_ellipse(slide.ellipse, b.find_slide(slide.id)->ellipse);
    EXPECT_EQ(slide.stroke, b.find_slide(slide.id)->stroke);
  }
}

// Everything but buffer 0 is the same value.
void expect_same_json(GltfJson a, GltfJson b) {
  for (GltfJson* json : {&a, &b}) {
    if (GltfJson* buffers = find_key(*json, "buffers"); buffers && !buffers->empty()) (*buffers)[0].erase("uri");
  }
  EXPECT_TRUE(gltf_json_text(a) == gltf_json_text(b)) << GltfJson::diff(a, b).dump().substr(0, 400);
}

TEST(Conversion, ThereAndBackKeepsMeshesSlidesCagesAndJson) {
  for (const std::filesystem::path& path : own_scenes()) {
    SCOPED_TRACE(path.string());
    SceneDocument unsaved(path);
    add_slides_and_cages(unsaved);
    const SceneDocument scene = reloaded(unsaved);  // a file holds floats
    const bool is_binary = path.extension() == ".glb";
    const SceneDocument there = scene.copy_as(!is_binary);
    const std::string bytes = there.bytes();
    EXPECT_EQ(bytes.starts_with("glTF"), !is_binary);
    expect_same_meshes(scene, there);
    expect_same_json(json_of(scene), json_of(there));
    const SceneDocument back = there.copy_as(is_binary);
    expect_same_meshes(scene, back);
    expect_same_json(json_of(scene), json_of(back));
  }
}

TEST(Conversion, ToGlbMovesTheFirstBufferIntoTheChunkAndLeavesTheOthers) {
  const SceneDocument text(std::filesystem::path(CAGEWRIGHT_OWN_SCENES) / "buffers_external_and_data_uri.gltf");
  const SceneDocument binary = text.copy_as(true);
  const GltfJson before = json_of(text), after = json_of(binary);
  EXPECT_EQ(find_key(after["buffers"][0], "uri"), nullptr);
  EXPECT_EQ(after["buffers"][1], before["buffers"][1]);
  std::string file = read_bytes(std::filesystem::path(CAGEWRIGHT_OWN_SCENES) / "buffers_external_and_data_uri.bin");
  file.resize((file.size() + 3) / 4 * 4, '\0');
  EXPECT_EQ(binary_of(binary), file);
  EXPECT_TRUE(binary.external_files().empty());
}

TEST(Conversion, ToGltfMovesTheChunkIntoTheTextAndLeavesTheOthers) {
  const SceneDocument binary(std::filesystem::path(CAGEWRIGHT_OWN_SCENES) / "buffers_glb_bin_and_external.glb");
  const SceneDocument text = binary.copy_as(false);
  const GltfJson before = json_of(binary), after = json_of(text);
  EXPECT_TRUE(after["buffers"][0]["uri"].get<std::string>().starts_with("data:application/octet-stream;base64,"));
  EXPECT_EQ(after["buffers"][1], before["buffers"][1]);
  EXPECT_EQ(binary_of(text.copy_as(true)), binary_of(binary));
}

// Another tool has put the cage's buffer first.
TEST(Conversion, LeavesACagesBufferInTheText) {
  GltfJson json = json_of("slides_cage.gltf");
  std::swap(json["buffers"][0], json["buffers"][1]);
  for (GltfJson& view : json["bufferViews"]) view["buffer"] = 1 - view["buffer"].get<int>();
  SceneDocument scene = scene_of(json);
  ASSERT_EQ(scene.cages().size(), 1u);
  CommandStack(scene).run(std::make_unique<SetCage>(some_cage(0, {3}, 1)));
  const SceneDocument binary = scene.copy_as(true);
  EXPECT_EQ(binary_of(binary), "");
  expect_same_meshes(reloaded(scene), binary);
}

TEST(Conversion, TakesBuffersThatAreShorterThanWhatHoldsThem) {
  GltfJson json = json_of("buffers_data_uri.gltf");
  std::string uri = json["buffers"][0]["uri"];
  const std::size_t content = uri.find_last_not_of('=') + 1;
  ASSERT_EQ((uri.size() - uri.find(',') - 1) % 4, 0u);
  if (content == uri.size()) json["buffers"][0]["uri"] = uri + "AAAA";
  const SceneDocument scene = scene_of(json);
  expect_same_meshes(SceneDocument(std::filesystem::path(CAGEWRIGHT_OWN_SCENES) / "buffers_data_uri.gltf"), scene);

  const TemporaryFolder folder;
  json["buffers"][0] = {{"uri", "a.bin"}, {"byteLength", json["buffers"][0]["byteLength"]}};
  folder.write("a.bin", binary_of(scene.copy_as(true)) + "more");
  folder.write("a.gltf", gltf_json_text(json));
  const SceneDocument from_file(folder / "a.gltf");
  expect_same_meshes(scene, from_file);
  EXPECT_EQ(binary_of(from_file.copy_as(true)), binary_of(scene.copy_as(true)));
}

TEST(Buffers, ThatAreNotTheFirstAreNeverTheBinaryChunk) {
  GltfJson json = json_of(SceneDocument(std::filesystem::path(CAGEWRIGHT_OWN_SCENES) / "slides_plain.glb"));
  json["buffers"].push_back(json["buffers"][0]);
  const std::string file = read_bytes(std::filesystem::path(CAGEWRIGHT_OWN_SCENES) / "slides_plain.glb");
  const GltfContainer container = split_gltf("a.glb", file);
  expect_file_error([&] { SceneDocument("a.glb", join_gltf("a.glb", container, gltf_json_text(json))); },
                    {"a.glb: buffer 1", "\"uri\"", "export it again"});
}

class ExternalCopies : public testing::Test {
 protected:
  // A scene in `in` with a buffer and images of these URIs; images need not be there.
  SceneDocument scene_with(const std::vector<std::string>& images) {
    std::filesystem::create_directories(folder / "in");
    std::filesystem::create_directories(folder / "out");
    GltfJson json = json_of("material_external_image.gltf");
    folder.write("in/a b.bin", read_bytes(std::filesystem::path(CAGEWRIGHT_OWN_SCENES) /
                                          json["buffers"][0]["uri"].get<std::string>()));
    json["buffers"][0]["uri"] = "a%20b.bin";
    json["images"] = GltfJson::array();
    for (const std::string& uri : images) json["images"].push_back({{"uri", uri}});
    folder.write("in/a.gltf", gltf_json_text(json));
    return SceneDocument(folder / "in/a.gltf");
  }
  Copies copies(const SceneDocument& scene) const { return external_copies(scene, folder / "out/b.gltf"); }

  TemporaryFolder folder;
};

TEST_F(ExternalCopies, AreWhatIsMissingByItsDecodedName) {
  folder.write("x", "");
  const SceneDocument scene = scene_with({"c%C3%A9.png", "d.png", "d.png", "./d.png", "data:image/png;base64,AAAA"});
  folder.write("in/c\xc3\xa9.png", "image");
  folder.write("in/d.png", "other");
  const Copies expected = {{folder / "out/a b.bin", folder.read("in/a b.bin")},
                           {folder / "out/c\xc3\xa9.png", "image"},
                           {folder / "out/d.png", "other"}};
  EXPECT_EQ(copies(scene), expected);
  EXPECT_TRUE(external_copies(scene, folder / "in/b.gltf").empty()) << "in the same folder";
  EXPECT_TRUE(external_copies(scene, folder / "out/../in/b.gltf").empty()) << "in the same folder";
}

TEST_F(ExternalCopies, AreNotMadeOfWhatIsThereAlready) {
  const SceneDocument scene = scene_with({});
  folder.write("out/a b.bin", folder.read("in/a b.bin"));
  EXPECT_TRUE(copies(scene).empty());
}

TEST_F(ExternalCopies, NeverOverwriteAnotherFile) {
  const SceneDocument scene = scene_with({});
  folder.write("out/a b.bin", "another");
  expect_file_error([&] { copies(scene); }, {(folder / "out/a b.bin").string(), "another file", "another folder"});
}

TEST_F(ExternalCopies, AreNotMadeOfWhatIsElsewhere) {
  std::filesystem::create_directories(folder / "out/deep");
  folder.write("up.png", "secret");
  const SceneDocument scene = scene_with(
      {"../up.png", "sub/../../up.png", "%2E%2E/up.png", (folder / "up.png").string(), "http://example.org/a.png",
       "https://example.org/up.png", "file:///etc/passwd", "missing.png", "", ".", "..", "sub", "d.png%00.txt"});
  std::filesystem::create_directories(folder / "in/sub");
  folder.write("in/d.png", "image");
  const Copies made = external_copies(scene, folder / "out/deep/b.gltf");
  ASSERT_EQ(made.size(), 1u);
  EXPECT_EQ(made[0].first, folder / "out/deep/a b.bin");
}

TEST_F(ExternalCopies, OfSubfoldersKeepThem) {
  const SceneDocument scene = scene_with({"textures/wood/a.png"});
  std::filesystem::create_directories(folder / "in/textures/wood");
  folder.write("in/textures/wood/a.png", "wood");
  ASSERT_EQ(copies(scene).size(), 2u);
  EXPECT_EQ(copies(scene)[1], Copies::value_type(folder / "out/textures/wood/a.png", "wood"));
}

TEST(Conversion, SaysThatUnknownChunksAreLeftOut) {
  for (const auto& [name, is_told] :
       {std::pair("buffers_glb_unknown_chunk.glb", true), {"buffers_glb_padded.glb", false}}) {
    const SceneDocument scene(std::filesystem::path(CAGEWRIGHT_OWN_SCENES) / name);
    EXPECT_TRUE(scene.lost_as(true).empty());
    ASSERT_EQ(scene.lost_as(false).size(), is_told ? 1u : 0u) << name;
    if (is_told) {
      EXPECT_NE(scene.lost_as(false)[0].find(std::string(name) + ": it has chunks that glTF does not know"),
                std::string::npos);
    }
  }
}

}  // namespace
}  // namespace cagewright::host::test
