// SPDX-License-Identifier: BSD-3-Clause
// What docs/scene-format.md says of slides "after other tools", a test for each of its sentences.
#include <gtest/gtest.h>

#include <chrono>

#include <cmath>
#include <random>

#include "host/command/command_stack.h"
#include "host/command/slide_commands.h"
#include "host/tests/expect_file_error.h"
#include "host/tests/scene/edited_scene.h"
#include "host/tests/scene/scene_files.h"

namespace cagewright::host::test {
namespace {

const Slide::Ellipse waist = {{0, 0.06, 0}, {0.245, 0, 0}, {0, 0, -0.196}};

GltfJson random_transform(std::mt19937& random) {
  std::normal_distribution<double> number;
  std::vector<double> q = {number(random), number(random), number(random), number(random)};
  const double length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  for (double& value : q) value /= length;
  const auto factor = [&] { return (number(random) < 0 ? -1 : 1) * std::exp(number(random)); };
  return {{"translation", {number(random), number(random), number(random)}},
          {"rotation", q},
          {"scale", {factor(), factor(), factor()}}};
}

void as_matrix(GltfJson& node) {
  const auto m = transform_in(node);
  for (const char* key : {"translation", "rotation", "scale"}) node.erase(key);
  std::vector<double> columns;
  for (std::size_t column = 0; column < 4; ++column) {
    for (std::size_t row = 0; row < 4; ++row) columns.push_back(row < 3 ? m[row][column] : column == 3);
  }
  node["matrix"] = columns;
}

// The scene with a chain of groups between the mesh node and slide `waist`, node 1.
GltfJson with_groups(std::size_t groups, std::mt19937& random) {
  GltfJson json = json_of("slides_plain.gltf");
  GltfJson& nodes = json["nodes"];
  nodes[1].update(random_transform(random));
  std::size_t child = 1;
  for (std::size_t i = 0; i < groups; ++i) {
    GltfJson group = random_transform(random);
    group["children"] = {child};
    child = nodes.size();
    nodes.push_back(std::move(group));
  }
  nodes[0]["children"] = {2, child};
  nodes[0].update(random_transform(random));  // has nothing to do with the slide in the mesh's space
  return json;
}

TEST(SlidesMovedByOtherTools, AreTheEllipseThatTheUnitCircleMapsTo) {
  for (unsigned seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    GltfJson json = with_groups(seed % 4, random);
    if (seed % 3 == 1) as_matrix(json["nodes"][1]);
    if (seed % 3 == 2) {
      for (GltfJson& node : json["nodes"]) as_matrix(node);
    }
    const SceneDocument scene = scene_of(json);
    const SceneSlide slide = slide_called(scene, "waist");
    EXPECT_EQ(slide.mesh_node, 0);
    EXPECT_EQ(slide.id, 1);
    expect_circle_maps_to(slide.ellipse, json, 1, 0);
    EXPECT_TRUE(slide.stroke.empty());
  }
}

// What is then changed here is written so that another reader sees the same, whatever is between.
TEST(SlidesMovedByOtherTools, CanBeChangedUnderAnyParents) {
  for (unsigned seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    SceneDocument scene = scene_of(with_groups(seed % 4, random));
    const Slide::Ellipse ellipse = some_ellipse(seed);
    const std::vector<Point3> stroke = {{0, 0, 0.1}, {1, 0, 0}, {0, 1, 0}};
    CommandStack(scene).run(std::make_unique<ChangeSlide>(1, ellipse, stroke));
    const SceneDocument again = reloaded(scene);
    ASSERT_EQ(again.slides().size(), 2u);
    const SceneSlide slide = slide_called(again, "waist");
    expect_same_curve(ellipse, slide.ellipse);
    EXPECT_EQ(slide.stroke, stroke);
    const GltfJson json = json_of(again);
    for (const GltfJson& node : json["nodes"]) EXPECT_EQ(find_key(node, "matrix"), nullptr) << "may be sheared";
  }
}

// The group's transform cannot be undone, or not well.
TEST(SlidesMovedByOtherTools, CanBeChangedUnderAGroupThatIsFlat) {
  for (const double flat : {0.0, 1e-13}) {
    std::mt19937 random(7);
    GltfJson json = with_groups(2, random);
    json["nodes"][1]["rotation"] = {0, 0, 0, 1};
    json["nodes"][3]["scale"] = {1, 1, flat};
    SceneDocument scene = scene_of(json);
    CommandStack(scene).run(std::make_unique<ChangeSlide>(1, some_ellipse(1)));
    expect_same_curve(some_ellipse(1), slide_called(reloaded(scene), "waist").ellipse);
  }
}

TEST(SlidesMovedByOtherTools, ThatHaveMoreContentStayWhereAParentIsSheared) {
  const auto lamp_under_slide = [](GltfJson& json) {
    json["nodes"][2]["children"] = {json["nodes"].size()};
    json["nodes"].push_back({{"name", "lamp"}});
  };
  SceneDocument scene = edited("slides_moved_sheared.gltf", lamp_under_slide);
  const GltfJson before = json_of(scene);
  CommandStack(scene).run(std::make_unique<ChangeSlide>(1, some_ellipse(2)));
  const GltfJson after = json_of(scene);
  for (const char* key : {"translation", "rotation", "scale", "children"}) {
    EXPECT_EQ(after["nodes"][2][key], before["nodes"][2][key]) << key;
  }
  EXPECT_EQ(after["nodes"][3], before["nodes"][3]);
  expect_same_curve(some_ellipse(2), slide_called(reloaded(scene), "waist").ellipse);
}

TEST(SlidesMovedByOtherTools, InTheFilesOfOurOwn) {
  const auto ellipse_in = [](const char* name) {
    return slide_called(edited(name, [](GltfJson&) {}), "waist").ellipse;
  };
  expect_ellipse(waist, ellipse_in("slides_moved_matrix.gltf"));
  expect_ellipse({{0, 0.06, 0}, {0, 0, 0.196}, {-0.245, 0, 0}}, ellipse_in("slides_moved_odd_scale.gltf"));
  expect_ellipse(waist, ellipse_in("slides_deep.gltf"));
  const GltfJson sheared = json_of("slides_moved_sheared.gltf");
  expect_circle_maps_to(ellipse_in("slides_moved_sheared.gltf"), sheared, 2, 0);
  EXPECT_NEAR(ellipse_in("slides_moved_sheared.gltf").center[1], 0.06, 1e-12);
}

TEST(SlidesMovedByOtherTools, LoseTheirStrokeWhateverWasMoved) {
  const std::vector<std::function<void(GltfJson&)>> moves = {
      [](GltfJson& json) { json["nodes"][1]["translation"][1] = 0.0601; },
      [](GltfJson& json) { json["nodes"][1]["scale"][0] = 0.2451; },
      [](GltfJson& json) { json["nodes"][1].erase("rotation"); },
      [](GltfJson& json) {  // a group between, which is moved
        json["nodes"][0]["children"] = {3, 2};
        json["nodes"].push_back({{"children", {1}}, {"translation", {0, 0.1, 0}}});
      }};
  for (const auto& move : moves) {
    EXPECT_TRUE(slide_called(edited("slides_plain.gltf", move), "waist").stroke.empty());
  }
  EXPECT_TRUE(slide_called(edited("slides_moved_stroke.gltf", [](GltfJson&) {}), "waist").stroke.empty());
}

TEST(SlidesThatWereNotMoved, KeepTheirStrokeHoweverTheTransformIsWritten) {
  const auto stroke = slide_called(edited("slides_plain.gltf", [](GltfJson&) {}), "waist").stroke;
  ASSERT_EQ(stroke.size(), 16u);
  const std::vector<std::function<void(GltfJson&)>> writings = {
      [](GltfJson& json) { as_matrix(json["nodes"][1]); },
      [](GltfJson& json) {  // numbers that went through floats
        for (const char* key : {"translation", "rotation", "scale"}) {
          for (GltfJson& value : json["nodes"][1][key]) value = double{static_cast<float>(*number_in(value))};
        }
      },
      [](GltfJson& json) {  // the same rotation
        for (GltfJson& value : json["nodes"][1]["rotation"]) value = -*number_in(value);
      },
      [](GltfJson& json) {  // a group that moves nothing
        json["nodes"][0]["children"] = {3, 2};
        json["nodes"].push_back({{"children", {1}}});
      }};
  for (const auto& write : writings) {
    SceneDocument scene = edited("slides_plain.gltf", write);
    EXPECT_EQ(slide_called(scene, "waist").stroke, stroke);
    CommandStack(scene).run(std::make_unique<RenameSlide>(1, "belly"));
    EXPECT_EQ(slide_called(reloaded(scene), "belly").stroke, stroke) << "is lost when saved";
  }
}

TEST(SlidesRenamedByOtherTools, HaveTheNewNameAndTheSameId) {
  const SceneDocument scene =
      edited("slides_plain.gltf", [](GltfJson& json) { json["nodes"][1]["name"] = "t\xc3\xa4ille"; });
  EXPECT_EQ(slide_called(scene, "t\xc3\xa4ille").id, 1);
  const SceneDocument unnamed = edited("slides_plain.gltf", [](GltfJson& json) { json["nodes"][1].erase("name"); });
  EXPECT_EQ(slide_called(unnamed, "slide 1").id, 1);
}

TEST(SlidesDeletedByOtherTools, AreGoneAndTheirCageStays) {
  const SceneDocument scene = edited("slides_cage_slide_deleted.gltf", [](GltfJson&) {});
  ASSERT_EQ(scene.slides().size(), 1u);
  EXPECT_EQ(scene.slides()[0].id, 4);
  ASSERT_EQ(scene.cages().size(), 1u);
  EXPECT_EQ(scene.cages()[0].slides, std::vector<std::int64_t>{3});
  EXPECT_EQ(scene.cages()[0].mesh.vertex_count(), 12u);
}

TEST(SlidesDeletedByOtherTools, LeaveTheirIdToTheCageThatNamesThem) {
  SceneDocument scene = edited("slides_cage.gltf", [](GltfJson& json) {
    json["nodes"][0]["children"] = {1};
    json["nodes"].erase(1);
  });
  EXPECT_EQ(scene.slides().size(), 0u);
  EXPECT_EQ(scene.new_slide_id(), 4);
}

TEST(SlidesDuplicatedByOtherTools, GetIdsAndNamesOfTheirOwnAndItIsSaid) {
  const SceneDocument scene = edited("slides_duplicated.gltf", [](GltfJson&) {});
  ASSERT_EQ(scene.slides().size(), 3u);
  EXPECT_EQ(slide_called(scene, "waist").id, 2);
  expect_ellipse(waist, slide_called(scene, "waist").ellipse);
  EXPECT_EQ(slide_called(scene, "waist.2").id, 3);
  EXPECT_EQ(slide_called(scene, "waist.3").id, 4);
  ASSERT_EQ(scene.notes().size(), 2u);
  EXPECT_NE(scene.notes()[0].find("edited.gltf: two slides have the id 2; \"waist\" gets 4"), std::string::npos);
  EXPECT_NE(scene.notes()[1].find("two slides are called \"waist\"; the second is now \"waist.3\""), std::string::npos);
  EXPECT_FALSE(scene.is_changed()) << "reading mends, but does not write";
}

TEST(SlidesDuplicatedByOtherTools, MayBeCalledAlikeUnderDifferentMeshes) {
  const SceneDocument scene = edited("slides_two_caged_meshes.gltf",
                                     [](GltfJson& json) { json["nodes"][3]["name"] = json["nodes"][2]["name"]; });
  EXPECT_TRUE(scene.notes().empty());
  EXPECT_EQ(scene.slides()[0].name, scene.slides()[1].name);
}

TEST(SlidesDuplicatedByOtherTools, GetAFreeIdEvenWhereTheLargestIsTaken) {
  SceneDocument scene = edited("slides_plain.gltf", [](GltfJson& json) {
    for (std::size_t node : {1, 2}) {
      json["nodes"][node]["extensions"]["CAGEWRIGHT_cut_slide"]["id"] = 9007199254740992;
    }
  });
  EXPECT_EQ(scene.slides()[0].id, 1) << "by id";
  EXPECT_EQ(scene.slides()[1].id, 9007199254740992);
  EXPECT_EQ(scene.new_slide_id(), 2);
  EXPECT_EQ(scene.new_slide_id(), 3);
  CommandStack(scene).run(std::make_unique<RenameSlide>(1, "other"));
  EXPECT_EQ(slide_called(reloaded(scene), "other").id, 1);
}

TEST(SlidesWithoutTheExtension, AreFoundByTheIdInExtras) {
  const SceneDocument scene = edited("slides_extension_dropped.gltf", [](GltfJson&) {});
  EXPECT_EQ(slide_called(scene, "waist").id, 5);
  EXPECT_EQ(slide_called(scene, "foot").id, 6);
  expect_ellipse(waist, slide_called(scene, "waist").ellipse);
  EXPECT_EQ(scene.cages().size(), 1u);
}

TEST(SlidesWithoutTheExtension, LoseTheirStrokeAndNotTheirEllipse) {
  const SceneDocument scene = edited("slides_plain.gltf", [](GltfJson& json) { json["nodes"][1].erase("extensions"); });
  EXPECT_EQ(slide_called(scene, "waist").id, 1);
  EXPECT_TRUE(slide_called(scene, "waist").stroke.empty());
  expect_ellipse(waist, slide_called(scene, "waist").ellipse);
}

// Godot's JSON has no other numbers.
TEST(SlidesWithoutTheExtension, MayHaveTheirIdAsAFraction) {
  const SceneDocument scene = edited("slides_extension_dropped.gltf", [](GltfJson& json) {
    json["nodes"][1]["extras"]["CAGEWRIGHT_cut_slide"]["id"] = 5.0;
  });
  EXPECT_EQ(slide_called(scene, "waist").id, 5);
}

TEST(SlidesWithoutExtensionAndExtras, AreOrdinaryNodes) {
  const SceneDocument scene = edited("slides_all_dropped.gltf", [](GltfJson&) {});
  EXPECT_TRUE(scene.slides().empty());
  EXPECT_TRUE(scene.cages().empty());
  EXPECT_EQ(scene.mesh_nodes().size(), 2u);
}

TEST(SlidesWhoseParentIsGone, BelongToTheOnlyMeshNodeAndStayWhereTheyAreInTheScene) {
  expect_ellipse(waist, slide_called(edited("slides_parent_gone.gltf", [](GltfJson&) {}), "waist").ellipse);
  for (unsigned seed = 0; seed < 20; ++seed) {
    std::mt19937 random(seed);
    SceneDocument scene = edited("slides_parent_gone.gltf", [&](GltfJson& json) {
      json["nodes"][0].update(random_transform(random));
      json["nodes"][1].update(random_transform(random));
    });
    const GltfJson json = json_of(scene);
    const Slide::Ellipse read = slide_called(scene, "waist").ellipse;
    EXPECT_EQ(slide_called(scene, "waist").mesh_node, 0);
    const auto expect_in_scene = [&](const Slide::Ellipse& e) {
      for (const double t : {0.0, 1.0, 2.0}) {
        const double c = std::cos(t), s = std::sin(t);
        const Point3 by_node = mapped_up(json, 1, none, {c, s, 0});
        Point3 local{};
        for (std::size_t k = 0; k < 3; ++k) local[k] = e.center[k] + c * e.u[k] + s * e.v[k];
        const Point3 by_ellipse = mapped_up(json, 0, none, local);
        for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(by_node[k], by_ellipse[k], 1e-10) << seed;
      }
    };
    expect_in_scene(read);
    CommandStack(scene).run(std::make_unique<RenameSlide>(1, "belly"));
    EXPECT_EQ(json_of(scene)["nodes"][0]["children"], GltfJson({1})) << "is not put under the mesh node";
    EXPECT_EQ(json_of(scene)["scenes"][0]["nodes"], GltfJson({0}));
    expect_same_curve(read, slide_called(reloaded(scene), "belly").ellipse);
  }
}

// A lamp hangs on the slide's node, which can then not go under the mesh node without moving it.
TEST(SlidesWhoseParentIsGone, StayAtTheRootWithWhatOthersHaveGivenThem) {
  for (const bool is_changed : {false, true}) {
    SceneDocument scene = edited("slides_parent_gone.gltf", [](GltfJson& json) {
      json["nodes"][0]["translation"] = {5, 6, 7};
      json["nodes"][1]["children"] = {2};
      json["nodes"].push_back({{"name", "lamp"}});
    });
    const Slide::Ellipse read = slide_called(scene, "waist").ellipse;
    EXPECT_NEAR(read.center[0], -5, 1e-12);
    const Slide::Ellipse expected = is_changed ? some_ellipse(3) : read;
    if (is_changed) CommandStack(scene).run(std::make_unique<ChangeSlide>(1, expected));
    CommandStack(scene).run(std::make_unique<RenameSlide>(1, "belly"));
    EXPECT_EQ(json_of(scene)["scenes"][0]["nodes"], GltfJson({0, 1}));
    EXPECT_EQ(json_of(scene)["nodes"][1]["children"], GltfJson({2}));
    EXPECT_EQ(json_of(scene)["nodes"][1]["name"], "belly") << "is the slide no more";
    expect_same_curve(expected, slide_called(reloaded(scene), "belly").ellipse);
  }
}

TEST(SlidesWhoseParentIsGone, AreNamedWhereThereAreSeveralMeshNodes) {
  const auto two_meshes = [](GltfJson& json) {
    json["nodes"].push_back({{"mesh", 0}});
    json["scenes"][0]["nodes"].push_back(2);
  };
  expect_file_error([&] { edited("slides_parent_gone.gltf", two_meshes); },
                    {"edited.gltf: slide \"waist\" (node 1)", "no node with a mesh", "move it"});
}

// Blender takes a skinned mesh from its node and gives it a node of its own, called as the mesh is.
TEST(SlidesWhoseParentIsGone, AreFoundByTheNameOfTheMeshWhereTheNodesNameIsNoLongerThere) {
  SceneDocument saved = as_it_is("nodes_instanced_mesh.gltf");
  CommandStack(saved).run(std::make_unique<AddSlide>(1, "new", some_ellipse(1)));
  const std::size_t slide = json_of(saved)["nodes"].size() - 1;
  for (const bool is_by_mesh : {false, true}) {
    GltfJson json = json_of(saved);
    for (GltfJson& node : json["nodes"]) node.erase("children");
    json["scenes"][0]["nodes"] = {0, 1, slide};
    if (is_by_mesh) {
      json["meshes"].push_back(json["meshes"][0]);
      json["meshes"][1]["name"] = "other";
      json["nodes"][0]["mesh"] = 1;
      json["nodes"][1]["name"] = "renamed";
    }
    EXPECT_EQ(slide_called(scene_of(json), "new").mesh_node, 1) << is_by_mesh;
  }
}

// glTF 2.0, 3.7.3.3: joints place a skinned mesh, its own node does not.
TEST(SlidesWhoseParentIsGone, AreWhereTheBindPoseOfASkinnedMeshHasThem) {
  const std::filesystem::path path = std::filesystem::path(CAGEWRIGHT_OWN_SCENES) / "geometry_skin.glb";
  SceneDocument saved = SceneDocument(path).copy_as(false);
  CommandStack(saved).run(std::make_unique<AddSlide>(0, "new", some_ellipse(1)));
  GltfJson json = json_of(saved);
  json["nodes"][0].erase("children");
  json["nodes"][0]["translation"] = {7, 7, 7};
  json["nodes"][1]["translation"] = {1, 1, 1};  // (0, -1, 0) before: all of the mesh is moved by (1, 2, 1)
  json["scenes"][0]["nodes"].push_back(3);
  for (int i = 0; i < 3; ++i) {
    GltfJson& value = json["nodes"][3]["translation"][static_cast<std::size_t>(i)];
    value = number_in(value).value() + (i == 1 ? 2 : 1);
  }
  expect_ellipse(some_ellipse(1), slide_called(scene_of(json), "new").ellipse, 1e-6);
}

// As Blender does: it leaves an empty where the node of a skinned mesh was, and writes the mesh as the scene showed it.
TEST(SlidesWhoseParentIsGone, KeepTheirPlaceOnSkinnedMeshesThatTheirNodeDoesNotShow) {
  const std::filesystem::path path = std::filesystem::path(CAGEWRIGHT_OWN_SCENES) / "geometry_skin.glb";
  GltfJson json = json_of(SceneDocument(path).copy_as(false));
  json["nodes"][0]["translation"] = {0.5, 2, 0};  // where its node is, and the mesh is not
  SceneDocument saved = scene_of(json);
  CommandStack(saved).run(std::make_unique<AddSlide>(0, "new", some_ellipse(1)));
  json = json_of(saved);
  GltfJson mesh_node = json["nodes"][0];
  mesh_node.erase("children");
  mesh_node.erase("translation");
  mesh_node["name"] = "mesh of its own";
  for (const char* key : {"mesh", "skin"}) json["nodes"][0].erase(key);
  json["nodes"].push_back(mesh_node);
  json["scenes"][0]["nodes"].push_back(json["nodes"].size() - 1);
  expect_ellipse(some_ellipse(1), slide_called(scene_of(json), "new").ellipse, 1e-6);
}

TEST(NestedSlides, LeaveNothingWhenAllAreRemoved) {
  const GltfJson plain = without_ours(*std::make_unique<SceneDocument>(as_it_is("slides_plain.gltf")));
  GltfJson json = json_of(as_it_is("slides_plain.gltf"));
  ASSERT_EQ(json["nodes"][0]["children"].size(), json["nodes"].size() - 1);
  json["nodes"][0]["children"] = {1};
  for (std::size_t i = 1; i + 1 < json["nodes"].size(); ++i) json["nodes"][i]["children"] = {i + 1};
  SceneDocument scene = scene_of(json);
  CommandStack stack(scene);
  for (const bool from_the_front : {true, false}) {
    while (!scene.slides().empty()) {
      const auto& slides = scene.slides();
      stack.run(std::make_unique<RemoveSlide>(from_the_front ? slides.front().id : slides.back().id));
    }
    EXPECT_EQ(json_of(scene)["nodes"], plain["nodes"]);
    while (stack.undo()) {
    }
    EXPECT_EQ(json_of(scene), json);
  }
}

// Seconds where every slide looks at all others.
TEST(ManySlides, CostInProportion) {
  constexpr std::size_t count = 20000;
  GltfJson json = json_of(as_it_is("slides_plain.gltf"));
  GltfJson slide = json["nodes"].back();
  slide["extensions"]["CAGEWRIGHT_cut_slide"] = {{"id", std::int64_t{1} << 53}};
  const std::size_t first = json["nodes"].size();
  for (std::size_t k = 0; k < count; ++k) {
    slide["children"] = {first + k + 1};
    slide["scale"] = {1, 1, 1};
    json["nodes"].push_back(slide);
  }
  json["nodes"].back().erase("children");
  json["nodes"][0]["children"].push_back(first);
  const auto begin = std::chrono::steady_clock::now();
  SceneDocument scene = scene_of(json);
  EXPECT_EQ(scene.slides().size(), first - 1 + count);
  CommandStack stack(scene);
  while (!scene.slides().empty()) stack.run(std::make_unique<RemoveSlide>(scene.slides().back().id));
  EXPECT_FALSE(scene.bytes().empty());
  EXPECT_LT(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(), 20);
}

}  // namespace
}  // namespace cagewright::host::test
