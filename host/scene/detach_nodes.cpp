// SPDX-License-Identifier: BSD-3-Clause
#include "host/scene/detach_nodes.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "host/file/gltf_own_nodes.h"
#include "host/scene/own_extension.h"

namespace cagewright::host {
namespace {

constexpr std::array<std::string_view, 5> own_keys = {"name", "translation", "rotation", "scale", "matrix"};

// Takes what is ours out of an array of node numbers.
void remove_items(SceneBase& base, GltfJson& object, const char* key, const std::string& pointer,
                  const std::set<int>& ours) {
  GltfJson* array = find_key(object, key);
  if (array == nullptr || !array->is_array()) return;
  GltfJson kept = GltfJson::array();
  for (GltfJson& item : *array) {
    if (!item.is_number_integer() || ours.count(item.get<int>()) == 0) kept.push_back(std::move(item));
  }
  const bool had_ours = kept.size() != array->size();
  *array = std::move(kept);
  if (had_ours && array->empty() && base.keeps.count(pointer) == 0) base.drops.insert(pointer);
}

// Where strays are among the roots of others.
void find_roots(const GltfJson& scenes, SceneContent& content, const OwnNodes& own, const std::set<int>& ours) {
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    const GltfJson* roots = find_key(scenes[i], "nodes");
    if (roots == nullptr || !roots->is_array()) continue;
    int others = 0;
    for (const GltfJson& root : *roots) {
      const int node = root.is_number_integer() ? root.get<int>() : -1;
      if (ours.count(node) == 0) ++others;
      const auto stray = std::find(own.strays.begin(), own.strays.end(), node);
      if (ours.count(node) == 0 || stray == own.strays.end()) continue;
      auto& as_read = content.strays[static_cast<std::size_t>(stray - own.strays.begin())].as_read;
      auto with_root = std::make_shared<CageAsRead>(*as_read);
      with_root->roots.emplace_back(static_cast<int>(i), others);
      as_read = std::move(with_root);
    }
  }
}

// Where other tools may have put them.
void remove_own_requirements(GltfJson& json) {
  GltfJson* required = find_key(json, "extensionsRequired");
  if (required == nullptr) return;
  GltfJson kept = GltfJson::array();
  for (GltfJson& name : *required) {
    if (!is_own_extension(name.get_ref<const std::string&>())) kept.push_back(std::move(name));
  }
  const bool had_ours = kept.size() != required->size();
  *required = std::move(kept);
  if (had_ours && required->empty()) json.erase("extensionsRequired");
}

// What others have of a pinned node: a cage's mesh is ours, and a skin needs one.
void leave_ordinary_node(GltfJson& node, bool was_cage) {
  remove_own_extensions(node);
  if (!was_cage) return;
  for (const char* key : {"mesh", "skin", "weights"}) node.erase(key);
}

}  // namespace

bool has_content_of_others(const GltfJson& node, bool is_cage) {
  const auto is_own = [is_cage](const auto& item) {
    if (item.key() == "extensions" || item.key() == "extras") {
      const auto& all = item.value().items();
      return item.value().is_object() &&
             std::all_of(all.begin(), all.end(), [](const auto& each) { return is_own_extension(each.key()); });
    }
    if (item.key() == "children") return item.value().empty();
    if (item.key() == "mesh") return is_cage;
    return std::find(own_keys.begin(), own_keys.end(), item.key()) != own_keys.end();
  };
  const auto& items = node.items();
  return !std::all_of(items.begin(), items.end(), is_own);
}

void detach_nodes(SceneBase& base, SceneContent& content, const OwnNodes& own) {
  GltfJson& nodes = *find_key(base.json, "nodes");
  std::set<int> ours;
  const auto collect = [&](const auto& owners, const std::vector<int>& places) {
    for (std::size_t k = 0; k < places.size(); ++k) {
      if (!owners[k].as_read->is_pinned) ours.insert(places[k]);
    }
  };
  collect(content.slides, own.slides);
  collect(content.cages, own.cages);
  collect(content.strays, own.strays);
  const bool at_the_end = ours.empty() || static_cast<std::size_t>(*ours.begin()) + ours.size() == nodes.size();
  const auto keep_homes = [&](auto& owners, const std::vector<int>& places, const auto& is_cage) {
    for (std::size_t k = 0; k < places.size(); ++k) {
      auto as_read = *owners[k].as_read;
      if (!at_the_end || as_read.is_pinned) as_read.home = places[k];
      if (as_read.is_pinned) leave_ordinary_node(nodes[static_cast<std::size_t>(places[k])], is_cage(k));
      owners[k].as_read = std::make_shared<decltype(as_read)>(std::move(as_read));
    }
  };
  keep_homes(content.slides, own.slides, [](std::size_t) { return false; });
  keep_homes(content.cages, own.cages, [](std::size_t) { return true; });
  keep_homes(content.strays, own.strays, [&](std::size_t k) { return content.strays[k].is_cage; });
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    remove_items(base, nodes[i], "children", "/nodes/" + std::to_string(i) + "/children", ours);
  }
  if (GltfJson* scenes = find_key(base.json, "scenes")) {
    find_roots(*scenes, content, own, ours);
    for (std::size_t i = 0; i < scenes->size(); ++i) {
      remove_items(base, (*scenes)[i], "nodes", "/scenes/" + std::to_string(i) + "/nodes", ours);
    }
  }
  for (const int node : ours) nodes[static_cast<std::size_t>(node)] = GltfJson::object();
  if (at_the_end) {
    nodes.erase(nodes.end() - static_cast<std::ptrdiff_t>(ours.size()), nodes.end());
  } else {
    base.holes = std::move(ours);
  }
  remove_own_requirements(base.json);
}

}  // namespace cagewright::host
