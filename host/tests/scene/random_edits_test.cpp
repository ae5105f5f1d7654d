// SPDX-License-Identifier: BSD-3-Clause
// Another tool edits a scene with slides and cages at random: counts nodes anew, adds its own, drops extensions.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <random>
#include <set>

#include "host/command/command_stack.h"
#include "host/command/slide_commands.h"
#include "host/tests/scene/edited_scene.h"
#include "host/tests/scene/scene_files.h"

namespace cagewright::host::test {
namespace {

constexpr char slide_key[] = "CAGEWRIGHT_cut_slide", cage_key[] = "CAGEWRIGHT_cage";
constexpr std::array<const char*, 2> keys = {slide_key, cage_key};
constexpr std::array<const char*, 2> holders = {"extensions", "extras"};

bool is_ours(const GltfJson& node) {
  return std::any_of(holders.begin(), holders.end(), [&](const char* holder) {
    const GltfJson* all = find_key(node, holder);
    return all && (find_key(*all, slide_key) || find_key(*all, cage_key));
  });
}

class RandomTool {
 public:
  RandomTool(GltfJson& json, unsigned seed) : json_(json), random_(seed) {}

  void edit() {
    const std::size_t first_foreign = json_["nodes"].size();
    for (std::size_t i = 0; i < first_foreign; ++i) {
      GltfJson& node = json_["nodes"][i];
      if (is_ours(node) && below(3) == 0) node.erase("extensions");
      if (is_ours(node) && !find_key(node, "mesh") && below(3) == 0)
        node["translation"] = {number(), number(), number()};
      if (is_ours(node) && below(5) == 0) node["extras"]["mine"] = nullptr;
      if (below(5) == 0) give_child(i);
    }
    for (std::size_t i = below(3); i > 0; --i) add_mesh();
    for (std::size_t i = below(4); i > 0; --i) json_["nodes"].push_back({{"name", "new"}});
    if (below(4) > 0) shuffle();
  }

 private:
  std::size_t below(std::size_t count) { return std::uniform_int_distribution<std::size_t>(0, count - 1)(random_); }
  double number() { return std::normal_distribution<double>()(random_); }

  void give_child(std::size_t node) {
    json_["nodes"][node]["children"].push_back(json_["nodes"].size());
    json_["nodes"].push_back({{"name", "child"}, {"extras", {1, nullptr}}});
  }

  // With accessors, views and a buffer of its own, and at the root of a scene where there is one.
  void add_mesh() {
    const std::size_t view = json_["bufferViews"].size(), accessor = json_["accessors"].size();
    json_["bufferViews"].push_back({{"buffer", json_["buffers"].size()}, {"byteLength", 36}});
    json_["buffers"].push_back(
        {{"byteLength", 36},
         {"uri", "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}});
    json_["accessors"].push_back({{"bufferView", view}, {"componentType", 5126}, {"count", 3}, {"type", "VEC3"}});
    const GltfJson primitive = {{"attributes", {{"POSITION", accessor}}}};
    json_["meshes"].push_back({{"primitives", GltfJson::array({primitive})}, {"name", "foreign"}});
    if (find_key(json_, "scenes")) json_["scenes"][0]["nodes"].push_back(json_["nodes"].size());
    json_["nodes"].push_back({{"mesh", json_["meshes"].size() - 1}});
  }

  void shuffle() {
    std::vector<std::size_t> place(json_["nodes"].size());
    std::iota(place.begin(), place.end(), 0);
    std::shuffle(place.begin(), place.end(), random_);
    const auto renumber = [&](GltfJson& object, const char* key) {
      GltfJson* found = find_key(object, key);
      if (found && found->is_number()) *found = place[found->get<std::size_t>()];
      for (std::size_t i = 0; found && found->is_array() && i < found->size(); ++i) {
        (*found)[i] = place[(*found)[i].get<std::size_t>()];
      }
    };
    const auto each = [&](GltfJson& object, const char* key, const auto& visit) {
      if (GltfJson* items = find_key(object, key)) {
        for (GltfJson& item : *items) visit(item);
      }
    };
    GltfJson moved = GltfJson::array();
    for (std::size_t i = 0; i < place.size(); ++i) moved.push_back(nullptr);
    for (std::size_t i = 0; i < place.size(); ++i) moved[place[i]] = json_["nodes"][i];
    json_["nodes"] = std::move(moved);
    each(json_, "nodes", [&](GltfJson& node) { renumber(node, "children"); });
    each(json_, "scenes", [&](GltfJson& scene) { renumber(scene, "nodes"); });
    each(json_, "skins", [&](GltfJson& skin) {
      renumber(skin, "joints");
      renumber(skin, "skeleton");
    });
    each(json_, "animations", [&](GltfJson& animation) {
      each(animation, "channels", [&](GltfJson& channel) { renumber(channel["target"], "node"); });
    });
  }

  GltfJson& json_;
  std::mt19937 random_;
};

std::size_t parent_in(const GltfJson& json, std::size_t node) {
  for (std::size_t i = 0; i < json["nodes"].size(); ++i) {
    const GltfJson* children = find_key(json["nodes"][i], "children");
    if (children && std::find(children->begin(), children->end(), node) != children->end()) return i;
  }
  return none;
}

void expect_slides_found(const SceneDocument& scene, const GltfJson& json) {
  std::map<std::string, std::size_t> nodes;  // names are unique in these scenes
  for (std::size_t i = 0; i < json["nodes"].size(); ++i) {
    const GltfJson& node = json["nodes"][i];
    if (is_ours(node) && !find_key(node, "mesh")) nodes[node["name"].get<std::string>()] = i;
  }
  EXPECT_EQ(scene.slides().size(), nodes.size());
  for (const auto& [name, node] : nodes) {
    const SceneSlide slide = slide_called(scene, name);
    const std::size_t mesh_node = parent_in(json, node);
    EXPECT_EQ(slide.mesh_node, static_cast<int>(mesh_node)) << name;
    expect_circle_maps_to(slide.ellipse, json, node, mesh_node);
  }
}

// What has to be left of a node when ours are gone; empty for nothing.
GltfJson left_of(GltfJson node, const std::set<std::size_t>& gone) {
  for (const char* holder : holders) {
    if (GltfJson* all = find_key(node, holder); all && all->is_object()) {
      const std::size_t had = all->size();
      for (const char* key : keys) all->erase(key);
      if (all->empty() && had > 0) node.erase(holder);
    }
  }
  if (GltfJson* children = find_key(node, "children")) {
    GltfJson kept = GltfJson::array();
    for (const GltfJson& child : *children) {
      if (gone.count(child.get<std::size_t>()) == 0) kept.push_back(child);
    }
    const bool is_gone = kept.empty() && !children->empty();
    *children = std::move(kept);
    if (is_gone) node.erase("children");
  }
  return node;
}

// What the meshes are made of: array and place.
std::set<std::pair<std::string, std::size_t>> own_geometry(const GltfJson& json, const std::set<std::size_t>& meshes) {
  std::set<std::pair<std::string, std::size_t>> own;
  for (const std::size_t mesh : meshes) {
    own.insert({"meshes", mesh});
    const GltfJson& primitive = json["meshes"][mesh]["primitives"][0];
    for (const GltfJson* index : {&primitive["attributes"]["POSITION"], &primitive["indices"]}) {
      const auto accessor = index->get<std::size_t>();
      const auto view = json["accessors"][accessor]["bufferView"].get<std::size_t>();
      own.insert({"accessors", accessor});
      own.insert({"bufferViews", view});
      own.insert({"buffers", json["bufferViews"][view]["buffer"].get<std::size_t>()});
    }
  }
  return own;
}

void expect_others_left(const GltfJson& edited, const GltfJson& left) {
  std::set<std::size_t> gone;
  const GltfJson& nodes = edited["nodes"];
  std::set<std::size_t> own_meshes;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (!is_ours(nodes[i])) continue;
    if (find_key(nodes[i], "mesh")) own_meshes.insert(nodes[i]["mesh"].get<std::size_t>());
    GltfJson rest = left_of(nodes[i], {});
    for (const char* key : {"name", "translation", "rotation", "scale", "mesh"}) rest.erase(key);
    if (rest.empty()) gone.insert(i);
  }
  ASSERT_LE(left["nodes"].size(), nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (i >= left["nodes"].size() || gone.count(i) > 0) {
      EXPECT_EQ(gone.count(i), 1u) << "node " << i;
      if (i < left["nodes"].size()) {
        EXPECT_EQ(left["nodes"][i], GltfJson::object());
      }
      continue;
    }
    GltfJson expected = left_of(nodes[i], gone);
    if (is_ours(nodes[i])) expected.erase("mesh");
    EXPECT_EQ(left["nodes"][i], expected) << "node " << i;
  }
  const std::set<std::pair<std::string, std::size_t>> own = own_geometry(edited, own_meshes);
  for (const char* array : {"meshes", "accessors", "bufferViews", "buffers"}) {
    for (std::size_t i = 0; i < left[array].size(); ++i) {
      if (own.count({array, i}) == 0) {
        EXPECT_EQ(left[array][i], edited[array][i]) << array << i;
      } else if (array == std::string("buffers")) {
        EXPECT_EQ(left[array][i]["byteLength"], 20) << "a cage is left in buffer " << i;
      }
    }
  }
  for (std::size_t i = left["meshes"].size(); i < edited["meshes"].size(); ++i) EXPECT_EQ(own_meshes.count(i), 1u);
  for (const auto& [key, value] : edited.items()) {
    const std::set<std::string> checked = {"nodes", "meshes", "accessors", "bufferViews", "buffers", "extensionsUsed"};
    if (checked.count(key) > 0) continue;
    EXPECT_EQ(left[key], value) << key;
  }
}

void give_names_of_their_own(GltfJson& json) {
  for (std::size_t i = 0; i < json["nodes"].size(); ++i) {
    GltfJson& node = json["nodes"][i];
    if (is_ours(node)) node["name"] = node["name"].get<std::string>() + " " + std::to_string(i);
  }
}

void rename_first_slide(SceneDocument& scene, const std::string& name) {
  CommandStack(scene).run(std::make_unique<RenameSlide>(scene.slides().front().id, name));
}

TEST(RandomEditsOfOtherTools, LeaveSlidesAndCagesThatAreFoundAndNothingOfOthersIsLost) {
  for (const char* name :
       {"nodes_instanced_mesh.gltf", "nodes_several_scenes.gltf", "nodes_matrix.gltf", "json_extras.gltf",
        "material_external_image.gltf", "geometry_skin.glb", "geometry_animation.glb", "nodes_several_meshes.glb"}) {
    SceneDocument original = SceneDocument(std::filesystem::path(CAGEWRIGHT_OWN_SCENES) / name).copy_as(false);
    add_slides_and_cages(original);
    GltfJson with_ours = json_of(original);
    give_names_of_their_own(with_ours);
    for (unsigned seed = 0; seed < 60; ++seed) {
      SCOPED_TRACE(name + std::string(", seed ") + std::to_string(seed));
      GltfJson edited = with_ours;
      RandomTool(edited, seed).edit();
      SceneDocument scene = scene_of(edited);
      EXPECT_FALSE(scene.is_changed());
      EXPECT_EQ(scene.cages().size(), original.cages().size());
      expect_slides_found(scene, edited);
      for (const SceneMeshNode& node : scene.mesh_nodes()) EXPECT_GT(scene.mesh(node.node).mesh.triangle_count(), 0u);

      rename_first_slide(scene, "one");
      SceneDocument saved_between = reloaded(scene);
      rename_first_slide(scene, "two");
      rename_first_slide(saved_between, "two");
      EXPECT_TRUE(scene.bytes() == saved_between.bytes()) << "what was saved between two changes matters";

      remove_all_of_ours(scene);
      const GltfJson left = json_of(scene);
      expect_others_left(edited, left);
      SceneDocument again = reloaded(scene);
      EXPECT_TRUE(again.slides().empty());
      EXPECT_TRUE(again.cages().empty());
      EXPECT_EQ(gltf_json_text(left).find("CAGEWRIGHT"), std::string::npos);
      add_slides_and_cages(again);
      remove_all_of_ours(again);
      EXPECT_EQ(again.bytes(), scene.bytes());
      if (testing::Test::HasFailure()) return;
    }
  }
}

}  // namespace
}  // namespace cagewright::host::test
