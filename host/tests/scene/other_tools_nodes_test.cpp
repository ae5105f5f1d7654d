// SPDX-License-Identifier: BSD-3-Clause
// What docs/scene-format.md says of other tools' nodes and content beside and under ours, and of cages.
#include <gtest/gtest.h>

#include "host/command/cage_commands.h"
#include "host/command/command_stack.h"
#include "host/command/slide_commands.h"
#include "host/tests/scene/edited_scene.h"
#include "host/tests/scene/scene_files.h"

namespace cagewright::host::test {
namespace {

TEST(ContentOfOthersOnASlide, StaysAsAnOrdinaryNodeWhenTheSlideIsRemoved) {
  SceneDocument scene = as_it_is("slides_foreign_child.gltf");
  const GltfJson before = json_of(scene);
  ASSERT_EQ(scene.slides().size(), 1u);
  const GltfJson after = without_ours(scene);
  GltfJson expected = before;
  expected["nodes"][1]["extensions"].erase("CAGEWRIGHT_cut_slide");
  expected["nodes"][1]["extras"].erase("CAGEWRIGHT_cut_slide");
  expected["extensionsUsed"].erase(0);
  EXPECT_EQ(after, expected);
}

TEST(ContentOfOthersOnASlide, StaysWhateverItIs) {
  const std::vector<std::pair<const char*, GltfJson>> contents = {
      {"camera", 0},
      {"unknown", GltfJson::object()},
      {"weights", {1}},
      {"extras", {{"mine", nullptr}}},
      {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}};
  for (const auto& [key, value] : contents) {
    SceneDocument scene = edited("slides_plain.gltf", [&, name = key](GltfJson& json) {
      GltfJson& content = json["nodes"][2][name];
      if (value.is_object())
        content.update(value);
      else
        content = value;
    });
    remove_all_of_ours(scene);
    const GltfJson left = json_of(scene);
    EXPECT_EQ(left["nodes"].size(), 3u) << key;
    EXPECT_EQ(left["nodes"][2][key], value) << key;
    EXPECT_EQ(left["nodes"][0]["children"], GltfJson({2})) << key;
    EXPECT_EQ(reloaded(scene).slides().size(), 0u) << key;
  }
}

TEST(ContentOfOthersOnASlide, StaysWhereItsNodeIsAnimatedOrAJoint) {
  SceneDocument scene = edited("slides_plain.gltf", [](GltfJson& json) {
    json["skins"] = {{{"joints", {1}}}};
    json["animations"] = {
        {{"channels", {{{"target", {{"node", 2}, {"path", "scale"}}}}}}, {"samplers", GltfJson::array()}}};
  });
  const GltfJson left = without_ours(scene);
  ASSERT_EQ(left["nodes"].size(), 3u);
  EXPECT_EQ(left["nodes"][1]["name"], "waist");
  EXPECT_EQ(left["nodes"][2]["name"], "foot");
}

TEST(NodesOfOthersAfterOurs, KeepTheirNumbersWhateverIsAddedAndRemoved) {
  SceneDocument scene = as_it_is("slides_before_foreign_nodes.gltf");
  const GltfJson before = json_of(scene);
  ASSERT_EQ(scene.slides().size(), 2u);
  ASSERT_EQ(scene.cages().size(), 1u);
  const auto expect_others_in_place = [&](const GltfJson& json) {
    EXPECT_EQ(json["nodes"][4], before["nodes"][4]);
    GltfJson ball = json["nodes"][5];
    ball.erase("children");  // its own new slides
    EXPECT_EQ(ball, before["nodes"][5]);
    EXPECT_EQ(json["meshes"][2], before["meshes"][2]);
    for (const char* array : {"accessors", "bufferViews"}) {
      for (const std::size_t i : {0, 1, 4, 5}) EXPECT_EQ(json[array][i], before[array][i]);
    }
    for (const std::size_t i : {0, 2}) EXPECT_EQ(json["buffers"][i], before["buffers"][i]);
    EXPECT_EQ(json["scenes"], before["scenes"]);
  };
  remove_all_of_ours(scene);
  const std::string without = scene.bytes();
  expect_others_in_place(json_of(scene));
  for (const std::size_t node : {1, 2, 3}) EXPECT_EQ(json_of(scene)["nodes"][node], GltfJson::object());
  EXPECT_EQ(json_of(scene)["nodes"].size(), 6u);

  add_slides_and_cages(scene);
  const GltfJson with = json_of(scene);
  expect_others_in_place(with);
  for (const std::size_t node : {1, 2, 3}) EXPECT_NE(find_key(with["nodes"][node], "extensions"), nullptr) << node;
  SceneDocument again = reloaded(scene);
  EXPECT_EQ(again.slides().size(), 4u);
  EXPECT_EQ(again.cages().size(), 2u);
  remove_all_of_ours(again);
  expect_others_in_place(json_of(again));

  // Removed and saved twice: the same bytes.
  SceneDocument first(scene.path(), without);
  EXPECT_EQ(first.bytes(), without);
  add_slides_and_cages(first);
  SceneDocument second = reloaded(first);
  remove_all_of_ours(second);
  EXPECT_EQ(second.bytes(), without);
}

TEST(EmptyArrays, AreThereAgainWhenOursAreRemoved) {
  SceneDocument scene = as_it_is("slides_keeps.gltf");
  const GltfJson left = without_ours(scene);
  EXPECT_EQ(left["nodes"], GltfJson({{{"name", "limb"}, {"mesh", 0}, {"children", GltfJson::array()}}}));
  for (const char* key : {"extensionsUsed", "images", "cameras"}) EXPECT_EQ(left[key], GltfJson::array()) << key;
}

TEST(EmptyArrays, AreRememberedWhenTheFirstOfOursGoes) {
  SceneDocument scene = as_it_is("slides_keeps.gltf");
  add_slides_and_cages(scene);
  CommandStack(scene).run(std::make_unique<RemoveSlide>(1));
  SceneDocument again = reloaded(scene);
  CommandStack(again).run(std::make_unique<RemoveSlide>(again.slides().front().id));
  SceneDocument third = reloaded(again);
  EXPECT_EQ(without_ours(third)["nodes"][0]["children"], GltfJson::array());
}

TEST(EmptyArrays, AreRememberedInTheSamePlaceWhateverWasSavedBetween) {
  SceneDocument scene = edited("slides_before_foreign_nodes.gltf", [](GltfJson& json) {
    json["nodes"][1]["extensions"]["CAGEWRIGHT_cut_slide"]["keeps"] = {"/extensionsUsed"};
  });
  CommandStack(scene).run(std::make_unique<RemoveSlide>(1));
  CommandStack(scene).run(std::make_unique<AddSlide>(0, "new", some_ellipse(1)));  // takes the first place
  SceneDocument saved_between = reloaded(scene);
  for (SceneDocument* each : {&scene, &saved_between}) {
    CommandStack(*each).run(std::make_unique<RenameSlide>(slide_called(*each, "new").id, "newer"));
  }
  EXPECT_EQ(scene.bytes(), saved_between.bytes());
  EXPECT_EQ(without_ours(saved_between)["extensionsUsed"], GltfJson::array());
}

// In Blender everything can be put under everything.
TEST(CagesAfterOtherTools, MayHaveASlideUnderThem) {
  const auto edit = [](GltfJson& json) {
    json["nodes"][0]["children"] = {2};
    json["nodes"][2]["children"] = {1};
  };
  SceneDocument scene = edited("slides_cage.gltf", edit);
  const Slide::Ellipse ellipse = slide_called(scene, "waist").ellipse;
  CommandStack stack(scene);
  stack.run(std::make_unique<SetCage>(some_cage(0, {3}, 1)));
  stack.run(std::make_unique<RenameSlide>(3, "belly"));
  expect_ellipse(ellipse, slide_called(reloaded(scene), "belly").ellipse);
  stack.run(std::make_unique<RemoveCage>(0));
  SceneDocument again = reloaded(scene);
  expect_ellipse(ellipse, slide_called(again, "belly").ellipse);
  EXPECT_TRUE(again.cages().empty());
}

// A mesh node was duplicated with all that is under it, and the meshes were not; others may have come after ours.
SceneDocument duplicated_limb(bool has_mesh_after) {
  return edited("slides_cage.gltf", [&](GltfJson& json) {
    GltfJson limb = json["nodes"][0], slide = json["nodes"][1], cage = json["nodes"][2];
    limb["children"] = {4, 5};
    for (const GltfJson& node : {limb, slide, cage}) json["nodes"].push_back(node);
    json["scenes"][0]["nodes"].push_back(3);
    if (has_mesh_after) json["meshes"].push_back(json["meshes"][0]);
  });
}

TEST(CagesAfterOtherTools, MayShareAMeshWhereTheirNodeWasDuplicated) {
  for (const bool has_mesh_after : {false, true}) {
    SceneDocument scene = duplicated_limb(has_mesh_after);
    ASSERT_EQ(scene.cages().size(), 2u);
    EXPECT_EQ(scene.slides()[1].id, 4);
    EXPECT_EQ(scene.cages()[0].slides, std::vector<std::int64_t>{3});
    EXPECT_EQ(scene.cages()[1].slides, std::vector<std::int64_t>{4}) << "the copy's cage is of the copy's slide";

    const TriangleMesh of_both = scene.cages()[0].mesh;
    CommandStack stack(scene);
    stack.run(std::make_unique<SetCage>(some_cage(3, {4}, 1)));
    const SceneDocument apart = reloaded(scene);
    EXPECT_EQ(apart.find_cage(0)->mesh.points, of_both.points) << "the other cage has changed, too";
    EXPECT_EQ(apart.find_cage(3)->mesh.vertex_count(), 4u);
    stack.undo();

    stack.run(std::make_unique<RemoveCage>(0));
    const SceneDocument one = reloaded(scene);
    ASSERT_EQ(one.cages().size(), 1u);
    EXPECT_EQ(one.find_cage(3)->mesh.points, of_both.points);
    EXPECT_EQ(one.mesh(0).mesh.triangle_count(), 98u);
    const GltfJson left = without_ours(scene), original = json_of("slides_cage.gltf");
    for (const char* array : {"accessors", "bufferViews", "buffers", "meshes"}) {
      for (std::size_t i = 0; i < original[array].size() / 2; ++i) EXPECT_EQ(left[array][i], original[array][i]);
    }
    EXPECT_EQ(left["nodes"][3], GltfJson({{"name", "limb"}, {"mesh", 0}}));
  }
}

TEST(CagesAfterOtherTools, KeepNumbersOfTheirCertificate) {
  SceneDocument scene = edited("slides_cage.gltf", [](GltfJson& json) {
    json["nodes"][2]["extensions"]["CAGEWRIGHT_cage"]["certificate"] =
        parse_gltf_json("a", R"({"closed":true,"volume":0.1000000000000000055,"count":123456789012345678901})");
  });
  CommandStack(scene).run(std::make_unique<RemoveSlide>(3));
  EXPECT_EQ(reloaded(scene).cages()[0].certificate,
            R"({"closed":true,"volume":0.1000000000000000055,"count":123456789012345678901})");
}

}  // namespace
}  // namespace cagewright::host::test
