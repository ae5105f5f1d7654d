// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "host/file/file_bytes.h"
#include "host/file/mesh_reader.h"
#include "host/scene/scene_document.h"
#include "host/tests/expect_file_error.h"
#include "host/tests/scene/broken_scenes.h"
#include "host/tests/scene/scene_files.h"

namespace cagewright::host::test {
namespace {

// The document, and the mesh of every node that has one.
void read_all(const std::filesystem::path& path) {
  const SceneDocument scene(path);
  for (const SceneMeshNode& node : scene.mesh_nodes()) scene.mesh(node.node);
}

bool says_what_to_do(const std::string& sentence) {
  const std::vector<std::string> steps = {"export it",
                                          "export the model",
                                          "mend it",
                                          "put it",
                                          "move it",
                                          "scale it",
                                          "take one out",
                                          "256 levels can",
                                          "copy",
                                          "export as",
                                          "closed surface is needed"};
  return std::any_of(steps.begin(), steps.end(),
                     [&](const std::string& step) { return sentence.find(step) != sentence.npos; });
}

TEST(BrokenScenes, AreRefusedWithASentenceThatNamesTheCulpritAndTheNextStep) {
  for (const BrokenScene& broken : broken_scenes()) {
    SCOPED_TRACE(broken.name);
    const std::filesystem::path path = broken_folder() / broken.name;
    expect_file_error([&] { read_all(path); }, {path.string(), broken.sentence});
    try {
      read_all(path);
    } catch (const FileError& error) {
      EXPECT_TRUE(says_what_to_do(error.what())) << error.what();
      EXPECT_EQ(error.reason().find("json.exception"), std::string::npos) << error.what();
    }
  }
}

TEST(BrokenScenes, AreRefusedAsMeshesToo) {
  for (const BrokenScene& broken : broken_scenes()) {
    if (broken.name.starts_with("slide_") || broken.name.starts_with("cage_")) continue;  // good as meshes
    // What is in no scene is of no interest to who wants a mesh.
    if (broken.name == "nodes_cycle_apart.gltf") continue;
    EXPECT_THROW(read_mesh(broken_folder() / broken.name), FileError) << broken.name;
  }
}

TEST(BrokenScenes, AreAllOfTheFolder) {
  std::set<std::string> known = readable_broken_scenes(), there;
  for (const BrokenScene& broken : broken_scenes()) known.insert(broken.name);
  for (const auto& entry : std::filesystem::directory_iterator(broken_folder())) {
    if (entry.path().extension() != ".bin") there.insert(entry.path().filename().string());
  }
  EXPECT_EQ(known, there);
}

TEST(BrokenScenes, ThatCanBeReadAllTheSameAreKeptAsTheyAre) {
  for (const std::string& name : readable_broken_scenes()) {
    const SceneDocument scene(broken_folder() / name);
    EXPECT_EQ(scene.bytes(), read_bytes(broken_folder() / name));
  }
}

TEST(BrokenScenes, SectionsOfOtherVerticesNoLongerCountAndItIsSaid) {
  SceneDocument scene(broken_folder() / "cage_sections_too_few.gltf");
  ASSERT_EQ(scene.notes().size(), 1u);
  for (const char* part : {"cage_sections_too_few.gltf", "cage \"limb cage\" (node 2)", "8 vertices", "for 1"}) {
    EXPECT_NE(scene.notes()[0].find(part), std::string::npos) << scene.notes()[0];
  }
  ASSERT_EQ(scene.cages().size(), 1u);
  EXPECT_TRUE(scene.cages()[0].sections.empty());
  EXPECT_TRUE(scene.cages()[0].certificate.empty());
  EXPECT_EQ(scene.cages()[0].mesh.vertex_count(), 8u);
  remove_all_of_ours(scene);
  EXPECT_EQ(scene.bytes().find("CAGEWRIGHT"), std::string::npos);
}

}  // namespace
}  // namespace cagewright::host::test
