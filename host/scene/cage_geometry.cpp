// SPDX-License-Identifier: BSD-3-Clause
#include "host/scene/cage_geometry.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>

#include "host/file/gltf_packing.h"
#include "host/scene/base64.h"

namespace cagewright::host {
namespace {

constexpr char data_uri[] = "data:application/octet-stream;base64,";

// The arrays of a file that hold a cage's geometry, and which of their items a block has.
constexpr std::array<const char*, 4> arrays = {"meshes", "accessors", "bufferViews", "buffers"};
std::vector<int> items_of(const CageBlock& block, std::size_t array) {
  switch (array) {
    case 0:
      return {block.mesh};
    case 1:
      return {block.positions, block.indices};
    case 2:
      return {block.position_view, block.index_view};
    default:
      return {block.buffer};
  }
}

std::string pointer_to(const char* array) { return std::string("/").append(array); }

std::optional<int> index_at(const GltfJson& object, const char* key) { return index_in(find_key(object, key)); }

const GltfJson* item(const GltfJson& json, const char* array, std::optional<int> index) {
  const GltfJson* items = find_key(json, array);
  if (!index || *index < 0 || items == nullptr || !items->is_array()) return nullptr;
  return static_cast<std::size_t>(*index) < items->size() ? &(*items)[static_cast<std::size_t>(*index)] : nullptr;
}

// How often each item is named under one of `keys`, anywhere but in extras.
void count_uses(const GltfJson& json, const std::vector<std::string>& keys, std::map<int, int>& uses) {
  if (json.is_array()) {
    for (const GltfJson& element : json) count_uses(element, keys, uses);
  }
  if (!json.is_object()) return;
  for (const auto& [key, value] : json.items()) {
    if (key == "extras") continue;
    if (value.is_number_integer() && std::find(keys.begin(), keys.end(), key) != keys.end()) ++uses[value.get<int>()];
    count_uses(value, keys, uses);
  }
}

void count_items(const GltfJson* object, std::map<int, int>& uses) {
  if (object == nullptr || !object->is_object()) return;
  for (const auto& [key, value] : object->items()) {
    if (value.is_number_integer()) ++uses[value.get<int>()];
  }
}

// Attributes and morph targets name accessors by keys of any name.
void count_attributes(const GltfJson& mesh, std::map<int, int>& uses) {
  const GltfJson* primitives = find_key(mesh, "primitives");
  if (primitives == nullptr || !primitives->is_array()) return;
  for (const GltfJson& primitive : *primitives) {
    count_items(find_key(primitive, "attributes"), uses);
    if (const GltfJson* targets = find_key(primitive, "targets"); targets && targets->is_array()) {
      for (const GltfJson& target : *targets) count_items(&target, uses);
    }
  }
}

class Uses {
 public:
  explicit Uses(const GltfJson& json) {
    const GltfJson empty = GltfJson::array();
    const auto part = [&](const char* key) -> const GltfJson& {
      const GltfJson* found = find_key(json, key);
      return found ? *found : empty;
    };
    count_uses(part("nodes"), {"mesh"}, meshes_);
    for (const GltfJson& mesh : part("meshes")) count_attributes(mesh, accessors_);
    count_uses(part("meshes"), {"indices"}, accessors_);
    count_uses(part("skins"), {"inverseBindMatrices"}, accessors_);
    count_uses(part("animations"), {"input", "output"}, accessors_);
    for (const char* where : {"accessors", "images", "meshes", "extensions", "bufferViews"}) {
      count_uses(part(where), {"bufferView"}, views_);
    }
    count_uses(part("bufferViews"), {"buffer"}, buffers_);
  }

  // Whether nothing but the block itself uses its items; the cage's node is no longer there.
  bool only_own(const CageBlock& block) const {
    return of(meshes_, block.mesh) == 0 && of(accessors_, block.positions) == 1 && of(accessors_, block.indices) == 1 &&
           of(views_, block.position_view) == 1 && of(views_, block.index_view) == 1 && of(buffers_, block.buffer) == 2;
  }

 private:
  static int of(const std::map<int, int>& uses, int index) {
    const auto found = uses.find(index);
    return found == uses.end() ? 0 : found->second;
  }
  std::map<int, int> meshes_, accessors_, views_, buffers_;
};

// The block of a mesh that has the layout that we write; empty for any other.
std::optional<CageBlock> block_of(const GltfJson& json, int mesh) {
  const GltfJson* mesh_json = item(json, "meshes", mesh);
  const GltfJson* primitives = mesh_json ? find_key(*mesh_json, "primitives") : nullptr;
  if (!primitives || !primitives->is_array() || primitives->size() != 1) return {};
  const GltfJson* attributes = find_key((*primitives)[0], "attributes");
  if (!attributes || attributes->size() != 1 || find_key((*primitives)[0], "targets")) return {};
  const auto positions = index_at(*attributes, "POSITION"), indices = index_at((*primitives)[0], "indices");
  const GltfJson *position_json = item(json, "accessors", positions), *index_json = item(json, "accessors", indices);
  if (!position_json || !index_json || positions == indices) return {};
  const auto position_view = index_at(*position_json, "bufferView"), index_view = index_at(*index_json, "bufferView");
  const GltfJson *first = item(json, "bufferViews", position_view), *second = item(json, "bufferViews", index_view);
  if (!first || !second || position_view == index_view) return {};
  const auto buffer = index_at(*first, "buffer");
  const GltfJson* buffer_json = item(json, "buffers", buffer);
  if (!buffer_json || index_at(*second, "buffer") != buffer) return {};
  const GltfJson* uri = find_key(*buffer_json, "uri");
  if (!uri || !uri->is_string() || uri->get_ref<const std::string&>().rfind("data:", 0) != 0) return {};
  return CageBlock{mesh, *positions, *indices, *position_view, *index_view, *buffer};
}

// Whether what the blocks have are the last items of each array.
bool are_last(const GltfJson& json, const std::vector<CageBlock>& blocks) {
  for (std::size_t a = 0; a < arrays.size(); ++a) {
    std::set<int> items;
    for (const CageBlock& block : blocks) {
      for (const int index : items_of(block, a)) items.insert(index);
    }
    const GltfJson* array = find_key(json, arrays[a]);
    if (!items.empty() && static_cast<std::size_t>(*items.begin()) + items.size() != array->size()) return false;
  }
  return true;
}

std::vector<GltfJson> geometry_of(const GltfJson& json, const CageBlock& block) {
  std::vector<GltfJson> geometry;
  for (std::size_t a = 0; a < arrays.size(); ++a) {
    for (const int index : items_of(block, a)) geometry.push_back(*item(json, arrays[a], index));
  }
  return geometry;
}

// Mesh, positions, indices, their two views and the buffer.
std::vector<GltfJson> make_geometry(const std::filesystem::path& path, const TriangleMesh& mesh,
                                    const std::string& name) {
  const PackedMesh packed = pack_mesh(path, mesh);
  const GltfJson primitive = {{"attributes", {{"POSITION", 0}}}, {"indices", 0}, {"mode", gltf_triangles}};
  return {
      {{"name", name}, {"primitives", GltfJson::array({primitive})}},
      {{"bufferView", 0},
       {"componentType", gltf_float},
       {"count", mesh.vertex_count()},
       {"type", "VEC3"},
       {"min", packed.least},
       {"max", packed.most}},
      {{"bufferView", 0}, {"componentType", packed.index_type}, {"count", mesh.triangles.size()}, {"type", "SCALAR"}},
      {{"buffer", 0}, {"byteOffset", 0}, {"byteLength", packed.position_bytes}, {"target", gltf_array_buffer}},
      {{"buffer", 0},
       {"byteOffset", packed.position_bytes},
       {"byteLength", packed.index_bytes},
       {"target", gltf_element_array_buffer}},
      {{"byteLength", packed.bytes.size()}, {"uri", data_uri + base64(packed.bytes)}}};
}

// The number that the array's next item gets.
int next_item(const SceneBase& base, GltfJson& json, const char* array, std::set<std::string>& filled) {
  GltfJson* items = find_key(json, array);
  if (items == nullptr) {
    json[array] = GltfJson::array();
    items = find_key(json, array);
  } else if (items->empty() && base.drops.count(pointer_to(array)) == 0) {
    filled.insert(pointer_to(array));
  }
  items->push_back(nullptr);
  return static_cast<int>(items->size()) - 1;
}

void place_geometry(std::vector<GltfJson> geometry, const CageBlock& block, GltfJson& json) {
  geometry[0]["primitives"][0]["attributes"]["POSITION"] = block.positions;
  geometry[0]["primitives"][0]["indices"] = block.indices;
  geometry[1]["bufferView"] = block.position_view;
  geometry[2]["bufferView"] = block.index_view;
  geometry[3]["buffer"] = geometry[4]["buffer"] = block.buffer;
  std::size_t k = 0;
  for (std::size_t a = 0; a < arrays.size(); ++a) {
    for (const int index : items_of(block, a)) json[arrays[a]][static_cast<std::size_t>(index)] = geometry[k++];
  }
}

// What a place holds that others' numbers keep, and no cage uses: one point.
std::vector<GltfJson> least_geometry() {
  TriangleMesh point;
  point.points = {0, 0, 0};
  point.triangles = {0, 0, 0};
  return make_geometry({}, point, "");
}

// A cage's new geometry, with what else the old one's mesh and its first primitive have: material, extras, extensions.
std::vector<GltfJson> new_geometry(const std::filesystem::path& path, const SceneCage& cage, const SceneBase& base) {
  std::vector<GltfJson> geometry = make_geometry(path, cage.mesh, cage.name);
  const CageAsRead* read = cage.as_read.get();
  if (read == nullptr) return geometry;
  const GltfJson* before = read->mesh >= 0 ? item(base.json, "meshes", read->mesh) : read->geometry.data();
  if (before == nullptr) return geometry;
  const auto keep = [](const GltfJson& from, const std::set<std::string>& but, GltfJson& to) {
    for (const auto& [key, value] : from.items()) {
      if (but.count(key) == 0) to[key] = value;
    }
  };
  keep(*before, {"primitives", "weights"}, geometry[0]);
  const GltfJson* primitives = find_key(*before, "primitives");
  if (primitives == nullptr || !primitives->is_array() || primitives->empty()) return geometry;
  GltfJson& primitive = geometry[0]["primitives"][0];
  keep((*primitives)[0], {"attributes", "indices", "mode", "targets"}, primitive);
  if (GltfJson* extensions = find_key(primitive, "extensions")) extensions->erase("KHR_draco_mesh_compression");
  return geometry;
}

void take_out(SceneBase& base, const std::vector<CageBlock>& blocks) {
  for (std::size_t a = 0; a < arrays.size(); ++a) {
    GltfJson& array = *find_key(base.json, arrays[a]);
    for (const CageBlock& block : blocks)
      array.erase(array.end() - static_cast<std::ptrdiff_t>(items_of(block, a).size()), array.end());
    if (array.empty() && base.keeps.count(pointer_to(arrays[a])) == 0) base.drops.insert(pointer_to(arrays[a]));
  }
}

}  // namespace

void detach_cage_geometry(SceneBase& base, SceneContent& content) {
  std::vector<std::shared_ptr<const CageAsRead>*> cages;
  for (SceneCage& cage : content.cages) cages.push_back(&cage.as_read);
  for (SceneStray& stray : content.strays) {
    if (stray.as_read->mesh >= 0) cages.push_back(&stray.as_read);
  }
  if (cages.empty()) return;
  const Uses uses(base.json);
  std::vector<CageBlock> blocks;
  std::vector<std::pair<std::shared_ptr<const CageAsRead>*, CageBlock>> own;
  std::set<int> meshes;
  for (auto* cage : cages) {
    const auto block = block_of(base.json, (*cage)->mesh);
    if (!block || !uses.only_own(*block)) continue;
    own.emplace_back(cage, *block);
    if (meshes.insert(block->mesh).second) blocks.push_back(*block);
  }
  if (own.empty()) return;
  const bool at_the_end = are_last(base.json, blocks);
  for (const auto& [cage, block] : own) {
    CageAsRead as_read = **cage;
    as_read.mesh = -1;
    as_read.geometry = geometry_of(base.json, block);
    // Of cages that share a mesh, as copies of a mesh node do, the first gets the place and the others new ones.
    if (meshes.erase(block.mesh) > 0 && !at_the_end) {
      as_read.block = static_cast<int>(base.blocks.size());
      base.blocks.push_back(block);
    }
    *cage = std::make_shared<CageAsRead>(std::move(as_read));
  }
  if (at_the_end) {
    take_out(base, blocks);
  } else {
    for (const CageBlock& block : blocks) place_geometry(least_geometry(), block, base.json);
  }
}

CageMeshes attach_cage_geometry(const std::filesystem::path& path, const SceneBase& base, const SceneContent& content,
                                const std::vector<bool>& is_new, GltfJson& json, std::set<std::string>& filled) {
  std::set<int> taken;
  const auto take = [&](const CageAsRead* read) {
    if (read && read->block >= 0) taken.insert(read->block);
  };
  for (const SceneCage& cage : content.cages) take(cage.as_read.get());
  for (const SceneStray& stray : content.strays) take(stray.as_read.get());
  const auto block_for = [&](const CageAsRead* read) {
    if (read && read->block >= 0) return base.blocks[static_cast<std::size_t>(read->block)];
    for (int free = 0; free < static_cast<int>(base.blocks.size()); ++free) {
      if (taken.insert(free).second) return base.blocks[static_cast<std::size_t>(free)];
    }
    const auto next = [&](const char* array) { return next_item(base, json, array, filled); };
    CageBlock block;
    block.mesh = next("meshes");
    block.positions = next("accessors");
    block.indices = next("accessors");
    block.position_view = next("bufferViews");
    block.index_view = next("bufferViews");
    block.buffer = next("buffers");
    return block;
  };
  const auto attach = [&](const CageAsRead* read, const SceneCage* made_anew) {
    if (!made_anew && read->mesh >= 0) return read->mesh;
    if (!made_anew && read->geometry.empty()) return -1;
    const CageBlock block = block_for(read);
    place_geometry(made_anew ? new_geometry(path, *made_anew, base) : read->geometry, block, json);
    return block.mesh;
  };
  CageMeshes meshes;
  for (std::size_t k = 0; k < content.cages.size(); ++k) {
    const SceneCage& cage = content.cages[k];
    meshes.cages.push_back(attach(cage.as_read.get(), is_new[k] ? &cage : nullptr));
  }
  for (const SceneStray& stray : content.strays) meshes.strays.push_back(attach(stray.as_read.get(), nullptr));
  return meshes;
}

}  // namespace cagewright::host
