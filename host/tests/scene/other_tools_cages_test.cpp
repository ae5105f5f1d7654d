// SPDX-License-Identifier: BSD-3-Clause
// What docs/scene-format.md says of cages after other tools, of cages that are replaced, and of what others have put
// into our extensions.
#include <gtest/gtest.h>

#include "host/command/cage_commands.h"
#include "host/command/command_stack.h"
#include "host/command/slide_commands.h"
#include "host/file/file_error.h"
#include "host/tests/scene/edited_scene.h"
#include "host/tests/scene/scene_files.h"

namespace cagewright::host::test {
namespace {

TEST(CagesAfterOtherTools, BelongToTheirParentWhateverSourceSays) {
  const SceneDocument scene = as_it_is("slides_cage_source_renumbered.gltf");
  ASSERT_EQ(scene.cages().size(), 1u);
  EXPECT_EQ(scene.cages()[0].mesh_node, 2);
}

TEST(CagesAfterOtherTools, AreFoundByExtrasWithoutSectionsAndCertificate) {
  const SceneDocument scene = as_it_is("slides_extension_dropped.gltf");
  ASSERT_EQ(scene.cages().size(), 1u);
  EXPECT_EQ(scene.cages()[0].slides, std::vector<std::int64_t>{5});
  EXPECT_EQ(scene.cages()[0].mesh.vertex_count(), 12u);
  EXPECT_TRUE(scene.cages()[0].sections.empty());
  EXPECT_EQ(scene.cages()[0].certificate, "");
}

TEST(CagesAfterOtherTools, ThatWereMovedAreRoundTheMeshWhereTheyAre) {
  const SceneDocument still = as_it_is("slides_cage.gltf");
  const SceneDocument mirrored = edited("slides_cage.gltf", [](GltfJson& json) {
    json["nodes"][2]["scale"] = {-2, 1, 1};
  });
  const TriangleMesh &a = still.cages()[0].mesh, &b = mirrored.cages()[0].mesh;
  for (std::size_t i = 0; i < a.vertex_count(); ++i) EXPECT_EQ(b.points[3 * i], -2 * a.points[3 * i]);
  EXPECT_EQ(a.triangles[0], b.triangles[0]);
  EXPECT_EQ(a.triangles[1], b.triangles[2]) << "a mirrored triangle has to turn the other way";
}

void put_at_the_root(GltfJson& json) {
  json["nodes"][0]["children"] = {1};
  json["scenes"][0]["nodes"] = {2, 0};
}

void add_other_mesh_node(GltfJson& json) {
  json["nodes"].push_back({{"name", "other limb"}, {"mesh", 0}});
  json["scenes"][0]["nodes"].push_back(json["nodes"].size() - 1);
}

TEST(StrayCages, StayAsTheyAreAndCanBeRemoved) {
  SceneDocument twice = edited("slides_cage.gltf", [](GltfJson& json) {
    json["nodes"][0]["children"].push_back(3);
    json["nodes"].push_back(json["nodes"][2]);
    json["nodes"][3]["mesh"] = 2;
    json["meshes"].push_back(json["meshes"][0]);
  });
  EXPECT_EQ(twice.cages().size(), 1u);
  EXPECT_TRUE(has_note(twice, "node 0 has two cages; cage \"limb cage\" (node 3) stays")) << twice.notes()[0];
  SceneDocument apart = edited("slides_cage.gltf", [](GltfJson& json) {
    put_at_the_root(json);
    add_other_mesh_node(json);
  });
  EXPECT_TRUE(apart.cages().empty());
  EXPECT_TRUE(has_note(apart, "cage \"limb cage\" (node 2) is under no node with a mesh"));
  for (SceneDocument* scene : {&twice, &apart}) {
    const GltfJson before = json_of(*scene);
    const std::size_t node = scene == &twice ? 3 : 2;
    ASSERT_EQ(scene->strays().size(), 1u);
    CommandStack stack(*scene);
    stack.run(std::make_unique<RenameSlide>(3, "renamed"));
    EXPECT_EQ(json_of(*scene)["nodes"][node], before["nodes"][node]);
    EXPECT_EQ(json_of(*scene)["meshes"], before["meshes"]);
    EXPECT_EQ(json_of(*scene)["scenes"], before["scenes"]);
    stack.run(std::make_unique<RemoveStray>(0));
    EXPECT_EQ(reloaded(*scene).strays().size(), 0u);
    EXPECT_EQ(reloaded(*scene).notes(), std::vector<std::string>());
    SceneDocument again = reloaded(*scene);
    EXPECT_EQ(gltf_json_text(without_ours(again)).find("CAGEWRIGHT"), std::string::npos);
    while (stack.undo()) {
    }
    EXPECT_EQ(json_of(*scene), before);
  }
}

TEST(StrayCages, DoNotExistToBeRemovedTwice) {
  SceneDocument scene = as_it_is("slides_cage.gltf");
  try {
    CommandStack(scene).run(std::make_unique<RemoveStray>(0));
    FAIL();
  } catch (const CommandError& error) {
    EXPECT_STREQ(error.what(), "there is no stray 0");
  }
}

TEST(CagesAfterOtherTools, ThatLostTheirParentAreRoundTheOnlyMesh) {
  const SceneDocument before = as_it_is("slides_cage.gltf");
  SceneDocument scene = edited("slides_cage.gltf", [](GltfJson& json) {
    put_at_the_root(json);
    json["nodes"][0]["translation"] = {1, 2, 3};
    json["nodes"][2]["translation"] = {1, 2, 3};
  });
  ASSERT_EQ(scene.cages().size(), 1u);
  EXPECT_EQ(scene.cages()[0].mesh_node, 0);
  EXPECT_EQ(scene.cages()[0].mesh.points, before.cages()[0].mesh.points);
  CommandStack(scene).run(std::make_unique<RenameSlide>(3, "renamed"));
  const GltfJson json = json_of(scene);
  EXPECT_EQ(json["nodes"][0]["children"].size(), 2u) << "the cage is under its mesh again";
  EXPECT_EQ(json["scenes"][0]["nodes"], GltfJson({0}));
  EXPECT_EQ(reloaded(scene).cages()[0].mesh.points, before.cages()[0].mesh.points);
}

TEST(CagesAfterOtherTools, ThatLostTheirParentAreFoundByItsName) {
  SceneDocument saved = as_it_is("slides_cage.gltf");
  CommandStack(saved).run(std::make_unique<SetCage>(some_cage(0, {3}, 1)));  // in a file that names the source
  GltfJson json = json_of(saved);
  put_at_the_root(json);
  add_other_mesh_node(json);
  const SceneDocument scene = scene_of(json);
  ASSERT_EQ(scene.cages().size(), 1u);
  EXPECT_EQ(scene.cages()[0].mesh_node, 0);
  EXPECT_TRUE(scene.strays().empty());
}

TEST(CagesAfterOtherTools, WithContentOfOthersKeepItOrLeaveAnOrdinaryNode) {
  const auto edit = [](GltfJson& json) {
    json["nodes"][2]["children"] = {3};
    json["nodes"].push_back({{"name", "lamp"}});
  };
  const GltfJson before = json_of(edited("slides_cage.gltf", edit));
  for (const bool is_replaced : {false, true}) {
    SceneDocument scene = edited("slides_cage.gltf", edit);
    CommandStack stack(scene);
    if (is_replaced) {
      stack.run(std::make_unique<SetCage>(some_cage(0, {3}, 1)));
      const SceneDocument again = reloaded(scene);
      ASSERT_EQ(again.cages().size(), 1u);
      EXPECT_EQ(again.cages()[0].mesh.vertex_count(), 4u);
      EXPECT_EQ(json_of(scene)["nodes"].size(), 4u);
      EXPECT_EQ(json_of(scene)["nodes"][2]["children"], GltfJson({3}));
    } else {
      stack.run(std::make_unique<RemoveCage>(0));
      EXPECT_EQ(json_of(scene)["nodes"][2], GltfJson({{"name", "limb cage"}, {"children", {3}}}));
    }
    EXPECT_EQ(json_of(scene)["nodes"][3], before["nodes"][3]);
    EXPECT_EQ(reloaded(scene).notes(), std::vector<std::string>());
    stack.undo();
    EXPECT_EQ(json_of(scene), before);
  }
}

// A cage that was moved cannot be replaced in its place without moving what others have put under it.
TEST(CagesAfterOtherTools, ThatWereMovedLeaveTheirNodeToOthersWhenReplaced) {
  SceneDocument scene = edited("slides_cage.gltf", [](GltfJson& json) {
    json["nodes"][2]["translation"] = {1, 0, 0};
    json["nodes"][2]["children"] = {3};
    json["nodes"].push_back({{"name", "lamp"}});
  });
  CommandStack(scene).run(std::make_unique<SetCage>(some_cage(0, {3}, 1)));
  EXPECT_EQ(json_of(scene)["nodes"][2],
            GltfJson({{"name", "limb cage"}, {"translation", {1, 0, 0}}, {"children", {3}}}));
  const SceneDocument again = reloaded(scene);
  ASSERT_EQ(again.cages().size(), 1u);
  for (std::size_t i = 0; i < 12; ++i) {
    EXPECT_NEAR(again.cages()[0].mesh.points[i], some_cage(0, {3}, 1).mesh.points[i], 1e-7);
  }
}

// In Blender a cage can be put under a slide.
TEST(CagesAfterOtherTools, UnderASlideDoNotMoveWithIt) {
  SceneDocument scene = edited("slides_cage.gltf", [](GltfJson& json) {
    json["nodes"][0]["children"] = {1};
    json["nodes"][1]["children"] = {2};
  });
  ASSERT_EQ(scene.cages().size(), 1u);
  const TriangleMesh before = scene.cages()[0].mesh;
  Slide::Ellipse ellipse = scene.slides()[0].ellipse;
  ellipse.center[1] += 0.3;
  CommandStack stack(scene);
  stack.run(std::make_unique<ChangeSlide>(3, ellipse));
  const SceneDocument again = reloaded(scene);
  ASSERT_EQ(again.cages().size(), 1u);
  ASSERT_EQ(again.cages()[0].mesh.points.size(), before.points.size());
  for (std::size_t i = 0; i < before.points.size(); ++i) {
    EXPECT_NEAR(again.cages()[0].mesh.points[i], before.points[i], 1e-6);
  }
  EXPECT_NEAR(again.slides()[0].ellipse.center[1], ellipse.center[1], 1e-12);
}

TEST(StrayCages, AreThoseThatWereMovedAndNodesThatLostTheirMesh) {
  SceneDocument scene = edited("slides_cage.gltf", [](GltfJson& json) {
    json["nodes"][0]["children"] = {1, 2, 3, 4};
    json["nodes"].push_back(json["nodes"][2]);
    json["nodes"][2]["translation"] = {1, 0, 0};
    json["nodes"].push_back(json["nodes"][3]);
    json["nodes"][4].erase("mesh");
  });
  ASSERT_EQ(scene.cages().size(), 1u);
  EXPECT_TRUE(has_note(scene, "(node 4) has no mesh"));
  EXPECT_TRUE(has_note(scene, "(node 2) stays as it is"));
  ASSERT_EQ(scene.strays().size(), 2u);
  CommandStack stack(scene);
  while (!scene.strays().empty()) stack.run(std::make_unique<RemoveStray>(0));
  EXPECT_EQ(gltf_json_text(without_ours(scene)).find("CAGEWRIGHT"), std::string::npos);
}

TEST(CagesThatAreReplaced, KeepMaterialNameAndWhatOthersGaveThem) {
  SceneDocument scene = edited("slides_cage.gltf", [](GltfJson& json) {
    json["materials"] = {{{"name", "glass"}}};
    json["meshes"][1]["primitives"][0]["material"] = 0;
    json["nodes"][2]["name"] = "my cage";
    json["nodes"][2]["extras"]["note"] = "keep";
    json["nodes"][2]["extensions"]["CAGEWRIGHT_cage"]["colour"] = "red";
  });
  SceneCage cage = some_cage(0, {3}, 1);
  cage.name = "";
  CommandStack(scene).run(std::make_unique<SetCage>(cage));
  const GltfJson json = json_of(scene);
  EXPECT_EQ(json["meshes"][1]["primitives"][0]["material"], 0);
  EXPECT_EQ(json["nodes"][2]["name"], "my cage");
  EXPECT_EQ(json["nodes"][2]["extras"]["note"], "keep");
  EXPECT_EQ(json["nodes"][2]["extensions"]["CAGEWRIGHT_cage"]["colour"], "red");
}

TEST(OwnExtensions, KeepUnknownKeysAndTheTextOfNumbers) {
  SceneDocument scene = edited("slides_cage.gltf", [](GltfJson& json) {
    json["nodes"][1]["extensions"]["CAGEWRIGHT_cut_slide"]["colour"] = {1, nullptr};
    json["nodes"][2]["extensions"]["CAGEWRIGHT_cage"]["parameters"]["orient.lambda"] = parse_gltf_json("", "4.000");
  });
  CommandStack stack(scene);
  stack.run(std::make_unique<RenameSlide>(3, "renamed"));
  const GltfJson before = json_of(scene);
  stack.run(std::make_unique<RenameSlide>(3, "renamed again"));
  const GltfJson after = json_of(scene);
  EXPECT_EQ(after["nodes"][1]["extensions"]["CAGEWRIGHT_cut_slide"]["colour"], GltfJson({1, nullptr}));
  EXPECT_NE(gltf_json_text(after).find("4.000"), std::string::npos);
  EXPECT_EQ(after["nodes"][2], before["nodes"][2]) << "a cage is not touched by a change of a slide's name";
}

TEST(OwnExtensions, MayHaveWholeNumbersWrittenAsFractions) {
  const SceneDocument scene = edited("slides_cage.gltf", [](GltfJson& json) {
    GltfJson& cage = json["nodes"][2]["extensions"]["CAGEWRIGHT_cage"];
    cage["source"] = 0.0;
    for (GltfJson& row : cage["sections"]) row = row.get<double>();
  });
  ASSERT_EQ(scene.cages().size(), 1u);
  EXPECT_EQ(scene.cages()[0].sections[0], 0);
  EXPECT_EQ(scene.cages()[0].sections.back(), -1);
}

TEST(OwnExtensions, ThatCannotBeReadAreRefusedOrStrays) {
  const GltfJson json = [] {
    GltfJson edited_json = json_of(as_it_is("slides_cage.gltf"));
    edited_json["nodes"][1]["extensions"]["CAGEWRIGHT_cut_slide"]["id"] = "three";
    edited_json["nodes"][2]["extensions"]["CAGEWRIGHT_cage"]["slides"] = 3;
    return edited_json;
  }();
  EXPECT_THROW(scene_of(json), FileError);
  SceneDocument scene("broken.gltf", gltf_json_text(json), SceneDocument::Unreadable::stray);
  EXPECT_EQ(scene.strays().size(), 2u);
  EXPECT_EQ(scene.notes().size(), 2u);
  EXPECT_EQ(json_of(scene), json);
  CommandStack stack(scene);
  for (int k = 0; k < 2; ++k) stack.run(std::make_unique<RemoveStray>(0));
  EXPECT_EQ(json_of(scene)["nodes"].size(), 1u);
  EXPECT_EQ(json_of(scene)["meshes"].size(), 1u);
  while (stack.undo()) {
  }
  EXPECT_EQ(json_of(scene), json);
}

TEST(OwnNodes, LeaveTheOrderOfKeysToOthers) {
  SceneDocument scene = edited("slides_cage.gltf", [](GltfJson& json) {
    GltfJson node = {{"mesh", 0}, {"children", {1, 2}}, {"name", "limb"}};
    json["nodes"][0] = node;
  });
  CommandStack stack(scene);
  stack.run(std::make_unique<RenameSlide>(3, "renamed"));
  EXPECT_EQ(gltf_json_text(json_of(scene)["nodes"][0]), R"({"mesh":0,"children":[1,2],"name":"limb"})");
  stack.run(std::make_unique<RemoveSlide>(3));
  stack.run(std::make_unique<RemoveCage>(0));
  EXPECT_EQ(gltf_json_text(json_of(scene)["nodes"][0]), R"({"mesh":0,"name":"limb"})");
}

// A place that others' numbers keep holds no cage any more.
TEST(RemovedCages, LeaveOnePointWhereOthersComeAfterThem) {
  SceneDocument scene = edited("slides_cage.gltf", [](GltfJson& json) { json["meshes"].push_back(json["meshes"][0]); });
  const GltfJson before = json_of(scene);
  CommandStack stack(scene);
  stack.run(std::make_unique<RemoveCage>(0));
  const GltfJson left = json_of(scene);
  EXPECT_EQ(left["meshes"].size(), 3u);
  EXPECT_EQ(left["buffers"].back()["byteLength"], 20);
  stack.run(std::make_unique<SetCage>(some_cage(0, {3}, 1)));
  EXPECT_EQ(json_of(scene)["meshes"].size(), 3u) << "the place is used again";
  stack.undo();
  stack.undo();
  EXPECT_EQ(json_of(scene), before);
}

}  // namespace
}  // namespace cagewright::host::test
