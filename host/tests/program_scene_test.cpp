// SPDX-License-Identifier: BSD-3-Clause
//
// The program on glTF scenes: which meshes it cages, what it writes into them, what it leaves alone.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "host/file/gltf_json.h"
#include "host/file/mesh_reader.h"
#include "host/file/mesh_writer.h"
#include "host/scene/scene_document.h"
#include "host/tests/run_program.h"
#include "host/tests/sample_meshes.h"
#include "host/tests/temporary_folder.h"

namespace cagewright::host {
namespace {

using nlohmann::json;
using Names = std::set<std::string>;
const std::map<std::string, std::string> real = {{"CAGEWRIGHT_PLUGIN", ""}};

constexpr const char* two_slides = R"({"version": 1, "slides": [{"name": "a", "point": [0,0,0], "normal": [0,1,0]},
                                       {"name": "b", "center": [0,0,0], "u": [1,0,0], "v": [0,0,1]}]})";

class ProgramScene : public testing::Test {
 protected:
  std::string at(const std::string& name) const { return (folder / name).string(); }

  // A scene of our own, in the folder.
  std::string own(const std::string& name) const {
    std::filesystem::copy_file(std::filesystem::path(CAGEWRIGHT_OWN_SCENES) / name, folder / name);
    return at(name);
  }

  static ProgramRun run(const std::vector<std::string>& arguments) {
    ProgramRun result = run_program(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    return result;
  }

  // The run failed with this code and one sentence that holds all parts, and left no file behind.
  void expect_failure(const std::vector<std::string>& arguments, int exit_code,
                      const std::vector<std::string>& parts) const {
    const Names before = folder.names();
    std::vector<std::string> quiet = arguments;
    quiet.emplace_back("--quiet");
    const ProgramRun result = run_program(quiet);
    EXPECT_EQ(result.exit_code, exit_code) << result.errors;
    EXPECT_EQ(result.output, "");
    EXPECT_EQ(result.errors.find('\n'), result.errors.size() - 1) << "not one sentence: " << result.errors;
    for (const std::string& part : parts)
      EXPECT_NE(result.errors.find(part), std::string::npos) << part << "\nis not in: " << result.errors;
    EXPECT_EQ(folder.names(), before);
  }

  // Of a .glb, with the order of keys.
  nlohmann::ordered_json scene_json(const std::string& name) const {
    const std::string bytes = folder.read(name);
    std::uint32_t size = 0;
    for (int i = 3; i >= 0; --i) size = size << 8 | static_cast<unsigned char>(bytes.at(12 + i));
    return nlohmann::ordered_json::parse(bytes.substr(20, size));
  }
  json read_json(const std::string& name) const { return json::parse(folder.read(name)); }

  static std::vector<std::string> slide_names(const SceneDocument& scene, int node) {
    std::vector<std::string> names;
    for (const SceneSlide& slide : scene.slides()) {
      if (slide.mesh_node == node) names.push_back(slide.name);
    }
    return names;
  }

  TemporaryFolder folder;
};

// ---- which mesh, which slides

TEST_F(ProgramScene, CagesWithTheSlidesOfTheSceneAndKeepsThem) {
  const std::string in = own("slides_plain.glb");
  run({"cage", in, "-o", at("out.glb"), "--report", at("r.json")});
  const SceneDocument before(in), after(at("out.glb"));
  ASSERT_EQ(after.slides().size(), 2u);
  for (const SceneSlide& slide : before.slides()) {
    const SceneSlide* kept = after.find_slide(slide.id);
    ASSERT_NE(kept, nullptr) << slide.id;
    EXPECT_EQ(kept->name, slide.name);
    EXPECT_EQ(kept->stroke, slide.stroke);
    EXPECT_EQ(kept->ellipse.center, slide.ellipse.center);
  }
  ASSERT_NE(after.find_cage(0), nullptr);
  EXPECT_EQ(after.find_cage(0)->name, "limb cage");
  EXPECT_EQ(after.find_cage(0)->slides, (std::vector<std::int64_t>{1, 7}));
  EXPECT_EQ(after.find_cage(0)->mesh.triangle_count(), 12u);
  const json report = read_json("r.json");
  EXPECT_EQ(report["slides"].size(), 2u);
  EXPECT_EQ(report["slides"][0]["name"], "waist");
  EXPECT_FALSE(report.contains("cages"));
}

TEST_F(ProgramScene, GivesSlidesOfAFileToTheOnlyMeshNode) {
  folder.write("s.json", two_slides);
  run({"cage", own("material_texture.glb"), "--slides", at("s.json"), "-o", at("out.glb")});
  const SceneDocument scene(at("out.glb"));
  EXPECT_EQ(slide_names(scene, 0), (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(scene.cages().size(), 1u);
  EXPECT_TRUE(scene.slides()[1].stroke.empty());
}

TEST_F(ProgramScene, SlidesOfAFileTakeThePlaceOfTheScenes) {
  folder.write("s.json", two_slides);
  run({"cage", own("slides_plain.gltf"), "--slides", at("s.json"), "-o", at("out.gltf")});
  const SceneDocument scene(at("out.gltf"));
  EXPECT_EQ(slide_names(scene, 0), (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(folder.read("out.gltf").find("waist"), std::string::npos);
  ASSERT_EQ(scene.cages().size(), 1u);
  EXPECT_EQ(scene.cages()[0].slides, (std::vector<std::int64_t>{scene.slides()[0].id, scene.slides()[1].id}));
}

TEST_F(ProgramScene, AsksWhichOfSeveralMeshNodesIsMeant) {
  folder.write("s.json", two_slides);
  const std::string in = own("nodes_instanced_mesh.gltf");
  expect_failure({"cage", in, "--slides", at("s.json"), "-o", at("out.glb")}, 3,
                 {"nodes_instanced_mesh.gltf", "0 (\"limb\")", "1 (\"again\")", "--node"});
  expect_failure({"cage", in, "-o", at("out.glb")}, 3, {"several nodes", "--node"});
}

TEST_F(ProgramScene, CagesAllMeshesAsOneWhereNoSceneIsWritten) {
  const ProgramRun result = run({"cage", own("nodes_several_meshes.glb"), "-o", at("cage.obj")});
  EXPECT_NE(result.errors.find("2 mesh nodes were merged"), std::string::npos) << result.errors;
  EXPECT_EQ(read_mesh(at("cage.obj")).mesh.triangle_count(), 12u);
}

TEST_F(ProgramScene, FindsTheNodeByNameAndByNumber) {
  folder.write("s.json", two_slides);
  const std::string in = own("nodes_instanced_mesh.gltf");
  for (const auto& [asked, node] : {std::pair("again", 1), std::pair("limb", 0), std::pair("1", 1)}) {
    run({"cage", in, "--slides", at("s.json"), "--node", asked, "-o", at("out.glb")});
    const SceneDocument scene(at("out.glb"));
    EXPECT_EQ(slide_names(scene, node).size(), 2u) << asked;
    EXPECT_EQ(slide_names(scene, 1 - node).size(), 0u) << asked;
    EXPECT_NE(scene.find_cage(node), nullptr) << asked;
    EXPECT_EQ(scene.cages().size(), 1u) << asked;
  }
}

TEST_F(ProgramScene, TakesANameThatIsANumberForTheName) {
  json scene = json::parse(std::ifstream(std::filesystem::path(CAGEWRIGHT_OWN_SCENES) / "nodes_instanced_mesh.gltf"));
  scene["nodes"][0]["name"] = "1";
  folder.write("in.gltf", scene.dump());
  run({"cage", at("in.gltf"), "--node", "1", "-o", at("out.glb")});
  EXPECT_NE(SceneDocument(at("out.glb")).find_cage(0), nullptr);
}

TEST_F(ProgramScene, RefusesASceneAsSlides) {
  const std::string in = own("slides_plain.glb");
  expect_failure({"cage", in, "--slides", in, "-o", at("out.glb")}, 3, {"slides_plain.glb: is a scene, and no slides"});
}

TEST_F(ProgramScene, RefusesNodesThatAreUnknownOrNotClear) {
  const std::string one = own("nodes_instanced_mesh.gltf"), two = own("nodes_several_meshes.glb");
  expect_failure({"cage", one, "--node", "nose", "-o", at("out.glb")}, 3,
                 {"nodes_instanced_mesh.gltf", "no node", "\"nose\"", "0 (\"limb\")", "1 (\"again\")"});
  expect_failure({"cage", one, "--node", "7"}, 3, {"no node", "\"7\""});
  expect_failure({"cage", one, "--node", ""}, 3, {"no node", "\"\""});
  expect_failure({"cage", two, "--node", "limb"}, 3, {"more than one node", "\"limb\"", "a number is enough"});
  folder.write("m.off", mesh_bytes(unit_cube(), "m.off"));
  expect_failure({"cage", at("m.off"), "--node", "0"}, 2, {"--node 0", "m.off", "no nodes"});
}

// ---- several cages

TEST_F(ProgramScene, CagesEveryNodeThatHasSlides) {
  const std::string in = own("slides_two_caged_meshes.gltf");
  const ProgramRun result = run({"cage", in, "-o", at("out.glb"), "--report", at("r.json")});
  const SceneDocument scene(at("out.glb"));
  ASSERT_EQ(scene.cages().size(), 2u);
  const SceneDocument before(in);
  for (const SceneCage& cage : before.cages()) EXPECT_EQ(scene.find_cage(cage.mesh_node)->name, cage.name);
  for (const SceneCage& cage : scene.cages()) EXPECT_EQ(cage.mesh.vertex_count(), 8u);
  EXPECT_EQ(scene.find_cage(0)->slides, std::vector<std::int64_t>{1});
  EXPECT_EQ(scene.find_cage(1)->slides, std::vector<std::int64_t>{2});
  const json report = read_json("r.json");
  ASSERT_EQ(report["cages"].size(), 2u);
  EXPECT_EQ(report["cages"][0]["node"], "node 0 (\"left\")");
  EXPECT_EQ(report["cages"][1]["node"], "node 1 (\"right\")");
  EXPECT_EQ(report["cages"][1]["slides"][0]["name"], "waist right");
  EXPECT_EQ(report["slides"], report["cages"][0]["slides"]);
  EXPECT_NE(result.output.find("node 0 (\"left\")\ncage: "), std::string::npos) << result.output;
  EXPECT_NE(result.output.find("node 1 (\"right\")\ncage: "), std::string::npos) << result.output;
}

TEST_F(ProgramScene, LeavesTheCagesOfNodesThatAreNotChosen) {
  const std::string in = own("slides_two_caged_meshes.gltf");
  run({"cage", in, "--node", "left", "-o", at("out.gltf"), "--report", at("r.json")});
  const SceneDocument before(in), after(at("out.gltf"));
  EXPECT_EQ(after.find_cage(0)->mesh.vertex_count(), 8u);
  EXPECT_EQ(after.find_cage(1)->mesh.points, before.find_cage(1)->mesh.points);
  EXPECT_EQ(after.slides().size(), 2u);
  EXPECT_FALSE(read_json("r.json").contains("cages"));
}

TEST_F(ProgramScene, RefusesOneCageFileForSeveralCages) {
  const std::string in = own("slides_two_caged_meshes.gltf");
  expect_failure({"cage", in, "-o", at("c.obj")}, 3, {"-o", "c.obj", "2 meshes", "node 0 (\"left\")", "--node"});
}

TEST_F(ProgramScene, ExitsWith1WhereOneOfSeveralCagesIsOpen) {
  const ProgramRun result = run_program({"cage", own("slides_two_caged_meshes.gltf"), "-o", at("out.glb")},
                                        {{"CAGEWRIGHT_FAKE", "open_cage"}});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_EQ(SceneDocument(at("out.glb")).find_cage(1)->certificate.find("\"closed\":true"), std::string::npos);
}

TEST_F(ProgramScene, NamesTheNodeWhoseSlidesAreRefused) {
  const std::string in = own("slides_two_caged_meshes.gltf");
  const ProgramRun result = run_program({"cage", in, "-o", at("out.glb")}, {{"CAGEWRIGHT_FAKE", "slides_touch"}});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_NE(result.errors.find("slides_two_caged_meshes.gltf: node 0 (\"left\"): "), std::string::npos)
      << result.errors;
  EXPECT_EQ(folder.names(), Names{"slides_two_caged_meshes.gltf"});
}

// ---- from a model without nodes

TEST_F(ProgramScene, MakesASceneOfAModelThatIsNone) {
  TriangleMesh model = unit_cube();
  for (double& x : model.points) x = 0.5 * x + 0.25;
  folder.write("m.obj", mesh_bytes(model, "m.obj"));
  const json stroke = {{0.5, 0.25, 0.25}, {0.75, 0.5, 0.25}, {0.5, 0.75, 0.25}, {0.25, 0.5, 0.5}, {0.3, 0.3, 0.25}};
  json slides = json::parse(two_slides);
  slides["slides"].push_back({{"name", "drawn"}, {"stroke", stroke}});
  folder.write("s.json", slides.dump());
  for (const std::string name : {"body.glb", "body.gltf"}) {
    SCOPED_TRACE(name);
    run({"cage", at("m.obj"), "--slides", at("s.json"), "-o", at(name), "--set", "refine.scope=part"});
    const SceneDocument scene(at(name));
    ASSERT_EQ(scene.mesh_nodes().size(), 1u);
    EXPECT_EQ(scene.mesh_nodes()[0].name, "body");
    const int node = scene.mesh_nodes()[0].node;
    EXPECT_EQ(scene.mesh(node).mesh.points, model.points);
    EXPECT_EQ(scene.mesh(node).mesh.triangles, model.triangles);
    EXPECT_EQ(slide_names(scene, node), (std::vector<std::string>{"a", "b", "drawn"}));
    EXPECT_EQ(json(scene.slides()[2].stroke), stroke);
    EXPECT_TRUE(scene.slides()[0].stroke.empty());
    const SceneCage* cage = scene.find_cage(node);
    ASSERT_NE(cage, nullptr);
    EXPECT_EQ(cage->name, "body cage");
    EXPECT_EQ(cage->slides.size(), 3u);
    EXPECT_EQ(cage->sections, std::vector<int>(8, -1));
    EXPECT_EQ(json::parse(cage->certificate)["closed"], true);
    EXPECT_EQ(cage->parameters[2], (std::pair<std::string, double>("refine.scope", 1)));
  }
  const json text = read_json("body.gltf");
  const json& drawn = text["nodes"][3]["extensions"]["CAGEWRIGHT_cut_slide"];
  EXPECT_EQ(drawn["stroke"], stroke);
  EXPECT_EQ(drawn["fitted"].size(), 10u);
  EXPECT_EQ(text["extensionsUsed"], json({"CAGEWRIGHT_cut_slide", "CAGEWRIGHT_cage"}));
  EXPECT_FALSE(text.contains("extensionsRequired"));
  EXPECT_EQ(folder.names(), (Names{"m.obj", "s.json", "body.glb", "body.gltf"})) << "buffers are in the text";
}

TEST_F(ProgramScene, KeepsSlideNamesWithQuotesAndOtherScripts) {
  const std::vector<std::string> names = {"kn\"ee\"", "\xe8\x86\x9d \xc3\xa9", "a/b\\c~", "two\nlines",
                                          "\xf0\x9f\xa6\xb4"};
  json slides = {{"version", 1}, {"slides", json::array()}};
  for (const std::string& name : names) {
    slides["slides"].push_back({{"name", name}, {"point", {0, 0, 0}}, {"normal", {0, 1, 0}}});
  }
  folder.write("s.json", slides.dump());
  const std::string in = own("json_strings.gltf");
  run({"cage", in, "--slides", at("s.json"), "-o", at("one.glb")});
  run({"cage", at("one.glb"), "-o", at("two.gltf"), "--report", at("r.json")});
  const SceneDocument scene(at("two.gltf"));
  EXPECT_EQ(slide_names(scene, scene.mesh_nodes().front().node), names);
  const json report = read_json("r.json");
  for (std::size_t k = 0; k < names.size(); ++k) EXPECT_EQ(report["slides"][k]["name"], names[k]);
}

// ---- other containers, other folders

TEST_F(ProgramScene, KeepsEverythingFromGlbToGltfAndBack) {
  for (const std::string name : {"slides_cage.glb", "material_texture.glb", "buffers_glb_padded.glb"}) {
    SCOPED_TRACE(name);
    const std::string in = own(name);
    run({"cage", in, "-o", at("straight.glb")});
    run({"cage", in, "-o", at("text.gltf")});
    run({"cage", at("text.gltf"), "-o", at("back.glb")});
    run({"strip", at("text.gltf"), "-o", at("stripped.gltf")});
    run({"strip", in, "-o", at("stripped.glb")});
    const SceneDocument a(at("straight.glb"));
    for (const std::string other : {"text.gltf", "back.glb"}) {
      const SceneDocument b(at(other));
      ASSERT_EQ(a.mesh_nodes().size(), b.mesh_nodes().size());
      EXPECT_EQ(a.mesh(0).mesh.points, b.mesh(0).mesh.points);
      EXPECT_EQ(a.mesh(0).mesh.triangles, b.mesh(0).mesh.triangles);
      ASSERT_EQ(a.slides().size(), b.slides().size());
      for (const SceneSlide& slide : a.slides()) EXPECT_EQ(slide.stroke, b.find_slide(slide.id)->stroke);
      EXPECT_EQ(a.find_cage(0)->mesh.points, b.find_cage(0)->mesh.points);
      EXPECT_EQ(a.find_cage(0)->certificate, b.find_cage(0)->certificate);
    }
    const SceneDocument text(at("stripped.gltf")), binary(at("stripped.glb"));
    EXPECT_TRUE(text.slides().empty() && text.cages().empty());
    EXPECT_EQ(text.mesh(0).mesh.points, binary.mesh(0).mesh.points);
  }
}

TEST_F(ProgramScene, TakesFilesThatTheSceneNamesIntoAnotherFolder) {
  std::filesystem::create_directory(folder / "in");
  std::filesystem::create_directory(folder / "out");
  const std::filesystem::path scenes = CAGEWRIGHT_OWN_SCENES;
  const std::vector<std::pair<std::string, std::vector<std::string>>> all = {
      {"material_external_image.gltf", {"material_external_image.bin", "material_external_image.png"}},
      {"buffers_percent_encoded.gltf", {"buffers percent-encoded.bin"}},
      {"buffers_glb_bin_and_external.glb", {"buffers_glb_bin_and_external.bin"}}};
  for (const auto& [scene, files] : all) {
    SCOPED_TRACE(scene);
    for (const std::string& name : files) std::filesystem::copy_file(scenes / name, folder / ("in/" + name));
    std::filesystem::copy_file(scenes / scene, folder / ("in/" + scene));
    run({"cage", at("in/" + scene), "-o", at("out/" + scene)});
    for (const std::string& name : files) EXPECT_EQ(folder.read("out/" + name), folder.read("in/" + name)) << name;
    const SceneDocument copy(at("out/" + scene));
    EXPECT_EQ(copy.mesh(0).mesh.points, SceneDocument(at("in/" + scene)).mesh(0).mesh.points);
    EXPECT_EQ(copy.cages().size(), 1u);
    run({"cage", at("in/" + scene), "-o", at("out/" + scene)});  // they are there already
  }
  folder.write("out/material_external_image.png", "another picture");
  std::filesystem::remove(folder / "out/material_external_image.gltf");
  expect_failure({"cage", at("in/material_external_image.gltf"), "-o", at("out/material_external_image.gltf")}, 3,
                 {"material_external_image.png", "another file", "another folder"});
  EXPECT_EQ(folder.read("out/material_external_image.png"), "another picture");
  EXPECT_FALSE(std::filesystem::exists(folder / "out/material_external_image.gltf"));
}

TEST_F(ProgramScene, CopiesNothingWithinTheFolder) {
  own("material_external_image.bin");
  own("material_external_image.png");
  const std::string in = own("material_external_image.gltf");
  const Names before = folder.names();
  const std::string buffer = folder.read("material_external_image.bin");
  run({"cage", in, "-o", in});
  EXPECT_EQ(folder.names(), before);
  EXPECT_EQ(folder.read("material_external_image.bin"), buffer);
  EXPECT_EQ(SceneDocument(in).cages().size(), 1u);
}

TEST_F(ProgramScene, RefusesToWriteOverWhatTheSceneNeeds) {
  const std::string bin = own("material_external_image.bin");
  own("material_external_image.png");
  const std::string in = own("material_external_image.gltf");
  const std::string before = folder.read("material_external_image.bin");
  expect_failure({"cage", in, "--report", bin}, 2, {"material_external_image.bin", "overwritten"});
  EXPECT_TRUE(folder.read("material_external_image.bin") == before);
  std::filesystem::create_directory(folder / "out");
  expect_failure({"cage", in, "-o", at("out/x.gltf"), "--report", at("out/material_external_image.bin")}, 2,
                 {"material_external_image.bin", "overwritten"});
  EXPECT_TRUE(std::filesystem::is_empty(folder / "out"));
}

// ---- strip, check

TEST_F(ProgramScene, StripGivesTheOriginalBack) {
  folder.write("s.json", two_slides);
  for (const std::string name : {"material_texture.glb", "json_numbers.glb", "json_unknown_extensions.glb"}) {
    const std::string in = own(name);
    run({"cage", in, "--slides", at("s.json"), "-o", at("with.glb")});
    const ProgramRun stripped = run({"strip", at("with.glb"), "-o", at("without.glb")});
    EXPECT_EQ(stripped.output, "taken out: 2 slides, 1 cage\n");
    EXPECT_EQ(scene_json("without.glb"), scene_json(name)) << "in the same order too";
    EXPECT_EQ(run({"strip", in, "-o", at("same.glb")}).output, "taken out: 0 slides, 0 cages\n");
    EXPECT_TRUE(folder.read("same.glb") == folder.read(name));
  }
}

TEST_F(ProgramScene, StripsWhatItCannotRead) {
  const std::filesystem::path broken = std::filesystem::path(CAGEWRIGHT_OWN_SCENES) / "broken";
  int stripped = 0;
  for (const auto& entry : std::filesystem::directory_iterator(broken)) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with("slide_") && !name.starts_with("cage_")) continue;
    SCOPED_TRACE(name);
    if (name == "slide_scale_infinite.gltf" || name == "slide_stroke_infinite.gltf") continue;  // no JSON numbers
    run({"strip", entry.path().string(), "-o", at("out.gltf")});
    const SceneDocument left(at("out.gltf"));
    EXPECT_TRUE(left.slides().empty() && left.cages().empty() && left.notes().empty());
    EXPECT_EQ(left.bytes().find("CAGEWRIGHT"), std::string::npos);
    ++stripped;
  }
  EXPECT_GT(stripped, 20);
}

TEST_F(ProgramScene, StripRefusesWhatIsNoScene) {
  const std::string in = own("slides_plain.glb");
  expect_failure({"strip", in, "-o", at("out.obj")}, 2, {"-o", "out.obj", "a scene is a .glb or .gltf"});
  expect_failure({"strip", at("m.obj"), "-o", at("out.glb")}, 2, {"m.obj", "a scene is a .glb or .gltf"});
  expect_failure({"strip", at("none.glb"), "-o", at("out.glb")}, 3, {"none.glb", "no such file"});
  expect_failure({"strip", in, "-o", at("no/out.glb")}, 3, {"out.glb", "no folder"});
}

TEST_F(ProgramScene, CageOfOursIsNoPartOfTheModelAndIsWhatCheckTakes) {
  const std::string in = own("slides_cage.glb");
  const ProgramRun checked = run({"check", in, in});
  EXPECT_NE(checked.output.find("slides_cage.glb\n  51 vertices, 98 triangles"), std::string::npos) << checked.output;
  EXPECT_NE(checked.output.find("slides_cage.glb\n  12 vertices"), std::string::npos) << checked.output;
  run({"cage", in, "-o", at("out.glb"), "--report", at("r.json")});
  EXPECT_EQ(read_json("r.json")["model"]["triangles"], 98);
  const ProgramRun other = run({"check", in, at("out.glb")});
  EXPECT_NE(other.output.find("out.glb\n  8 vertices, 12 triangles"), std::string::npos) << other.output;
}

TEST_F(ProgramScene, ForgetsACertificateWhereCageOrModelWereChanged) {
  ASSERT_EQ(run_program({"cage", own("slides_plain.gltf"), "-o", at("with.gltf")}, real).exit_code, 0);
  EXPECT_NE(SceneDocument(at("with.gltf")).cages()[0].certificate, "");
  const GltfJson made = parse_gltf_json({}, folder.read("with.gltf"));
  for (const bool is_cage : {false, true}) {
    GltfJson changed = made;
    if (is_cage) {
      changed["nodes"].back()["translation"] = {0.125, 0, 0};
    } else {
      changed["meshes"][0]["primitives"].push_back(changed["meshes"][0]["primitives"][0]);
    }
    folder.write("changed.gltf", gltf_json_text(changed));
    const SceneDocument scene(at("changed.gltf"));
    EXPECT_EQ(scene.cages()[0].certificate, "") << is_cage;
    ASSERT_EQ(scene.notes().size(), 1u);
    EXPECT_NE(scene.notes()[0].find("its certificate no longer counts"), std::string::npos);
  }
}

TEST_F(ProgramScene, CheckSeesACageFromItsModel) {
  const auto with_cage_moved = [&](const char* name, double x, double model_x) {
    GltfJson scene = parse_gltf_json({}, folder.read("with.gltf"));
    for (GltfJson& node : scene["nodes"]) {
      if (find_key(node, "extensions") && find_key(node["extensions"], "CAGEWRIGHT_cage"))
        node["translation"] = {x, 0, 0};
    }
    scene["nodes"][0]["translation"] = {model_x, 0, 0};
    folder.write(name, gltf_json_text(scene));
    return run_program({"check", at(name), at(name)}, real);
  };
  ASSERT_EQ(run_program({"cage", own("slides_plain.gltf"), "-o", at("with.gltf")}, real).exit_code, 0);
  EXPECT_EQ(with_cage_moved("still.gltf", 0, 0).exit_code, 0);
  EXPECT_EQ(with_cage_moved("together.gltf", 0, 10).exit_code, 0);
  EXPECT_EQ(with_cage_moved("apart.gltf", 10, 0).exit_code, 1);
}

// ---- what is said

TEST_F(ProgramScene, TellsWhatWasMendedAndWhatIsBroken) {
  const ProgramRun mended = run({"cage", own("slides_duplicated.gltf"), "-o", at("out.gltf")});
  EXPECT_NE(mended.errors.find("two slides are called \"waist\""), std::string::npos) << mended.errors;
  std::filesystem::copy_file(std::filesystem::path(CAGEWRIGHT_OWN_SCENES) / "broken/nodes_cycle.gltf",
                             folder / "nodes_cycle.gltf");
  expect_failure({"cage", at("nodes_cycle.gltf"), "-o", at("x.glb")}, 3, {"nodes_cycle.gltf", "node"});
}

TEST_F(ProgramScene, RefusesACageThatNoSceneCanHold) {
  expect_failure({"cage", own("slides_plain.glb"), "--lambda", "inf", "-o", at("out.glb")}, 3,
                 {"out.glb", "\"orient.lambda\"", "not finite"});
}

// ---- with the plug-in that users have

TEST_F(ProgramScene, GoesTheWholeRoadWithTheRealPlugin) {
  const std::string in = own("slides_plain.glb");
  const ProgramRun made = run_program({"cage", in, "-o", at("out.glb"), "--report", at("r.json")}, real);
  ASSERT_EQ(made.exit_code, 0) << made.errors;
  const SceneDocument scene(at("out.glb"));
  const SceneCage* cage = scene.find_cage(0);
  ASSERT_NE(cage, nullptr);
  EXPECT_EQ(cage->slides, (std::vector<std::int64_t>{1, 7}));
  ASSERT_EQ(cage->sections.size(), cage->mesh.vertex_count());
  for (const int row : {0, 1}) EXPECT_EQ(std::count(cage->sections.begin(), cage->sections.end(), row), 4) << row;
  json certificate = json::parse(cage->certificate);
  EXPECT_EQ(certificate.erase("of"), 1u);
  EXPECT_EQ(certificate, read_json("r.json")["certificate"]);
  const json parameters = json::parse(run_program({"params", "--json"}, real).output);
  ASSERT_EQ(cage->parameters.size(), parameters.size());
  for (std::size_t k = 0; k < parameters.size(); ++k) EXPECT_EQ(cage->parameters[k].first, parameters[k]["id"]);
  const ProgramRun checked = run_program({"check", in, at("out.glb")}, real);
  EXPECT_EQ(checked.exit_code, 0) << checked.output;
  EXPECT_NE(checked.output.find("51 vertices"), std::string::npos) << checked.output;
  const ProgramRun again = run_program({"cage", at("out.glb"), "-o", at("again.glb")}, real);
  ASSERT_EQ(again.exit_code, 0) << again.errors;
  EXPECT_TRUE(folder.read("again.glb") == folder.read("out.glb")) << "the same scene gives the same bytes";
}

TEST_F(ProgramScene, TellsOfParametersThatTheScenesCageHadAndThisOneHasNot) {
  const std::string in = own("slides_plain.glb");
  const std::vector<std::string> set = {"--set", "refine.delta=0.01", "--set", "enclose.in_plane=false"};
  std::vector<std::string> first = {"cage", in, "-o", at("out.glb")},
                           again = {"cage", at("out.glb"), "-o", at("again.glb")};
  first.insert(first.end(), set.begin(), set.end());
  EXPECT_EQ(run_program(first, real).exit_code, 0);
  EXPECT_NE(run_program(again, real)
                .errors.find("the scene's cage was made with other parameters than this one; to keep "
                             "them: --set refine.delta=0.01 --set enclose.in_plane=false\n"),
            std::string::npos);
  again.insert(again.end(), set.begin(), set.end());
  EXPECT_EQ(run_program(again, real).errors.find("other parameters"), std::string::npos);
}

}  // namespace
}  // namespace cagewright::host
