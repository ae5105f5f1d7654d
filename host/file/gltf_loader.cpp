// SPDX-License-Identifier: BSD-3-Clause
#include "host/file/gltf_loader.h"

#include <tiny_gltf.h>

#include <initializer_list>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "host/file/file_error.h"
#include "host/file/gltf_buffers.h"
#include "host/file/gltf_check.h"
#include "host/file/gltf_own_nodes.h"

namespace cagewright::host {
namespace {

constexpr char draco[] = "KHR_draco_mesh_compression";

// The keys of an object that we read, with their values.
GltfJson only(const GltfJson& object, std::initializer_list<const char*> keys) {
  GltfJson kept = GltfJson::object();
  for (const char* key : keys) {
    if (const GltfJson* value = find_key(object, key)) kept[key] = *value;
  }
  return kept;
}

// Which of these an object has under `holder`. tinygltf drops empty objects from extras and all but objects from
// extensions.
void keep_marks(const GltfJson& object, const char* holder, std::initializer_list<const char*> names, GltfJson& kept) {
  const bool is_extras = std::string_view(holder) == "extras";
  const GltfJson* all = find_key(object, holder);
  for (const char* name : names) {
    if (all && find_key(*all, name)) kept[holder][name] = is_extras ? GltfJson(true) : GltfJson::object();
  }
}

GltfJson node_view(const GltfJson& node) {
  GltfJson kept =
      only(node, {"name", "children", "mesh", "skin", "camera", "translation", "rotation", "scale", "matrix"});
  for (const char* holder : {"extensions", "extras"}) {
    keep_marks(node, holder, {slide_extension, cage_extension}, kept);
  }
  return kept;
}

GltfJson mesh_view(const GltfJson& mesh) {
  GltfJson kept = only(mesh, {"name"});
  kept["primitives"] = GltfJson::array();
  for (const GltfJson& primitive : *find_key(mesh, "primitives")) {
    GltfJson view = only(primitive, {"attributes", "indices", "mode"});
    keep_marks(primitive, "extensions", {draco}, view);
    kept["primitives"].push_back(std::move(view));
  }
  return kept;
}

// What tinygltf reads for us, so that it stumbles over nothing else. Precondition: check_gltf has passed.
GltfJson view_of(const GltfJson& json) {
  GltfJson kept = only(json, {"asset", "scene", "accessors", "bufferViews"});
  const auto each = [&](const char* array, auto view) {
    const GltfJson* items = find_key(json, array);
    if (items == nullptr) return;
    kept[array] = GltfJson::array();
    for (const GltfJson& item : *items) kept[array].push_back(view(item));
  };
  each("scenes", [](const GltfJson& scene) { return only(scene, {"nodes"}); });
  each("nodes", node_view);
  each("meshes", mesh_view);
  return kept;
}

// tinygltf's messages are one or more lines; the first says it.
std::string first_line(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(" \r\n");
  if (begin == text.npos) return "unknown reason";
  std::string line = text.substr(begin, text.find_first_of("\r\n", begin) - begin);
  while (!line.empty() && (line.back() == '.' || line.back() == ' ')) line.pop_back();
  for (char& c : line) {
    if (c < ' ' || c > '~') c = '?';
  }
  return line.size() > 200 ? line.substr(0, 200) + "..." : line;
}

bool skip_image(tinygltf::Image*, const int, std::string*, std::string*, int, int, const unsigned char*, int, void*) {
  return true;
}

void refuse_compression(const std::filesystem::path& path, const GltfJson& json) {
  const GltfJson* required = find_key(json, "extensionsRequired");
  if (required == nullptr) return;
  for (const GltfJson& extension : *required) {
    const bool is_draco = extension == draco;
    if (!is_draco && extension != "EXT_meshopt_compression") continue;
    throw FileError(path, {},
                    std::string("its meshes are compressed with ") + (is_draco ? "Draco" : "meshopt") +
                        ", which cannot be read; export it without compression");
  }
}

}  // namespace

void load_gltf(const std::filesystem::path& path, std::string_view bytes, tinygltf::Model& model) {
  const GltfContainer container = split_gltf(path, bytes);
  load_gltf(path, container, parse_container_json(path, container), model);
}

void load_gltf(const std::filesystem::path& path, const GltfContainer& container, const GltfJson& json,
               tinygltf::Model& model) {
  check_gltf(path, json);
  refuse_compression(path, json);
  const std::string view = gltf_json_text(view_of(json));
  if (view.size() > std::numeric_limits<unsigned int>::max()) throw FileError(path, {}, "has more than 4 GiB of JSON");
  tinygltf::TinyGLTF loader;
  loader.SetImageLoader(skip_image, nullptr);
  std::string error, warning;
  bool is_good = false;
  try {
    is_good = loader.LoadASCIIFromString(&model, &error, &warning, view.data(), static_cast<unsigned int>(view.size()),
                                         path.parent_path().string());
  } catch (const std::exception& failure) {  // tinygltf indexes some empty arrays with at()
    error += failure.what();
  }
  // tinygltf reports success though it left out a primitive that it could not parse; its messages tell.
  if (!is_good || !error.empty()) {
    throw FileError(path, {}, "cannot be read as glTF 2.0: " + first_line(error) + "; export it again");
  }
  for (std::vector<unsigned char>& bytes : read_gltf_buffers(path, container, json)) {
    model.buffers.emplace_back().data = std::move(bytes);
  }
}

}  // namespace cagewright::host
