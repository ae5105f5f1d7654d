// SPDX-License-Identifier: BSD-3-Clause
// Scenes through the program, with the fake plug-in.
#include <gtest/gtest.h>

#include <algorithm>

#include "host/file/file_bytes.h"
#include "host/file/file_error.h"
#include "host/file/gltf_json.h"
#include "host/scene/scene_document.h"
#include "host/tests/run_program.h"
#include "host/tests/scene/broken_scenes.h"
#include "host/tests/temporary_folder.h"

namespace cagewright::host::test {
namespace {

std::filesystem::path own_scene(const std::string& name) { return std::filesystem::path(CAGEWRIGHT_OWN_SCENES) / name; }

// Exit 3, one line after the progress that names the file, and nothing written.
void expect_refused(const std::string& name, const std::string& sentence) {
  SCOPED_TRACE(name);
  const TemporaryFolder folder;
  const std::string input = (broken_folder() / name).string();
  const ProgramRun run = run_program({"cage", input, "-o", (folder / "out.glb").string(), "--quiet"});
  EXPECT_EQ(run.exit_code, 3) << run.errors;
  EXPECT_EQ(run.output, "");
  EXPECT_EQ(std::count(run.errors.begin(), run.errors.end(), '\n'), 1) << run.errors;
  EXPECT_EQ(run.errors.find("cagewright: " + input), 0u) << run.errors;
  EXPECT_NE(run.errors.find(sentence), std::string::npos) << run.errors;
  EXPECT_TRUE(folder.names().empty());
}

TEST(SceneProgram, RefusesBrokenScenesWithOneLineAndWritesNothing) {
  // The first of each kind, and every fifth.
  std::string kind;
  std::size_t row = 0;
  for (const BrokenScene& broken : broken_scenes()) {
    const std::string its_kind = broken.name.substr(0, broken.name.find_first_of("_."));
    if (its_kind != kind || row++ % 5 == 0) expect_refused(broken.name, broken.sentence);
    kind = its_kind;
  }
}

TEST(SceneProgram, RefusesAFileWithoutMeshes) { expect_refused("holds_no_mesh.gltf", "no triangles"); }

TEST(SceneProgram, DoesNotPutAnotherSceneInThePlaceOfOneWhoseMeshesHaveNoNodes) {
  const TemporaryFolder folder;
  GltfJson json = parse_gltf_json("a.gltf", read_bytes(own_scene("slides_plain.gltf")));
  for (const char* key : {"scene", "scenes", "nodes", "extensionsUsed"}) json.erase(key);
  const std::string before = gltf_json_text(json, 2), file = (folder / "a.gltf").string();
  folder.write("a.gltf", before);
  const ProgramRun run = run_program({"cage", file, "-o", file});
  EXPECT_EQ(run.exit_code, 3) << run.errors;
  EXPECT_NE(run.errors.find(file + ": no node has a mesh"), std::string::npos) << run.errors;
  EXPECT_EQ(folder.read("a.gltf"), before);
  EXPECT_EQ(run_program({"cage", file, "-o", (folder / "a.obj").string()}).exit_code, 0);
}

TEST(SceneProgram, SaysWhatItHadToMend) {
  const TemporaryFolder folder;
  const std::string out = (folder / "out.glb").string();
  const ProgramRun run = run_program({"cage", own_scene("slides_duplicated.gltf").string(), "-o", out});
  EXPECT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_NE(run.errors.find("two slides have the id 2"), std::string::npos) << run.errors;
  EXPECT_EQ(SceneDocument(out).slides().size(), 3u);
}

TEST(SceneProgram, TakesTheFilesOfAGltfAlong) {
  const TemporaryFolder folder;
  const std::string out = (folder / "out.gltf").string();
  const ProgramRun run = run_program({"cage", own_scene("material_external_image.gltf").string(), "-o", out});
  EXPECT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_EQ(folder.names(),
            (std::set<std::string>{"material_external_image.bin", "material_external_image.png", "out.gltf"}));
  EXPECT_EQ(folder.read("material_external_image.png"), read_bytes(own_scene("material_external_image.png")));
  EXPECT_EQ(SceneDocument(out).cages().size(), 1u);
}

TEST(SceneProgram, MakesTheFoldersOfTheFilesThatItTakesAlong) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder / "in/textures/wood");
  std::filesystem::create_directories(folder / "out");
  for (const char* ending : {"gltf", "bin"}) {
    folder.write(std::string("in/material_external_image.") + ending,
                 read_bytes(own_scene(std::string("material_external_image.") + ending)));
  }
  std::string text = folder.read("in/material_external_image.gltf");
  const std::string image = "material_external_image.png";
  text.replace(text.find(image), image.size(), "textures/wood/a.png");
  folder.write("in/material_external_image.gltf", text);
  folder.write("in/textures/wood/a.png", "wood");
  const std::string in = (folder / "in/material_external_image.gltf").string();
  const auto cage = [&](const std::string& slides) {
    return run_program({"cage", in, "-o", (folder / "out/out.gltf").string(), "--slides", slides});
  };
  folder.write("wrong.json", "{}");
  EXPECT_EQ(cage((folder / "wrong.json").string()).exit_code, 3);
  EXPECT_FALSE(std::filesystem::exists(folder / "out/textures"));
  folder.write("none.json", R"({"version": 1, "slides": []})");
  EXPECT_EQ(cage((folder / "none.json").string()).exit_code, 0);
  EXPECT_EQ(folder.read("out/textures/wood/a.png"), "wood");
}

TEST(SceneProgram, WritesNothingWhereAFileOfTheGltfWouldBeOverwritten) {
  const TemporaryFolder folder;
  folder.write("material_external_image.png", "another");
  const ProgramRun run =
      run_program({"cage", own_scene("material_external_image.gltf").string(), "-o", (folder / "out.gltf").string()});
  EXPECT_EQ(run.exit_code, 3) << run.errors;
  EXPECT_NE(run.errors.find("another file"), std::string::npos) << run.errors;
  EXPECT_EQ(folder.names(), (std::set<std::string>{"material_external_image.png"}));
  EXPECT_EQ(folder.read("material_external_image.png"), "another");
}

}  // namespace
}  // namespace cagewright::host::test
