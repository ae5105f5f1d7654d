// SPDX-License-Identifier: BSD-3-Clause
#include "host/file/gltf_check.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <string>

#include "host/file/file_error.h"

namespace cagewright::host {
namespace {

class Checker {
 public:
  Checker(const std::filesystem::path& path, const GltfJson& json) : path_(path), json_(json) {}

  void run() const {
    if (!json_.is_object()) fail("is not glTF: the root of its JSON is no object");
    check_asset();
    for (const char* key : {"extensionsUsed", "extensionsRequired"}) check_strings(key);
    for (const char* key :
         {"scenes", "nodes", "meshes", "accessors", "bufferViews", "buffers", "skins", "animations"}) {
      check_array_of_objects(key);
    }
    index("", json_, "scene", "scenes");
    each("scenes", "scene",
         [&](const std::string& at, const GltfJson& scene) { indices(at, scene, "nodes", "nodes"); });
    each("nodes", "node", [&](const std::string& at, const GltfJson& node) { check_node(at, node); });
    each("meshes", "mesh", [&](const std::string& at, const GltfJson& mesh) { check_mesh(at, mesh); });
    each("accessors", "accessor", [&](const std::string& at, const GltfJson& it) { check_accessor(at, it); });
    each("buffers", "buffer", [&](const std::string& at, const GltfJson& it) {
      required(at, it, "byteLength");
      whole(at, it, "byteLength");
      string(at, it, "uri");
    });
    each("bufferViews", "buffer view", [&](const std::string& at, const GltfJson& it) { check_view(at, it); });
    each("skins", "skin", [&](const std::string& at, const GltfJson& skin) {
      indices(at, skin, "joints", "nodes");
      index(at, skin, "skeleton", "nodes");
      index(at, skin, "inverseBindMatrices", "accessors");
    });
    each("animations", "animation", [&](const std::string& at, const GltfJson& it) { check_animation(at, it); });
  }

 private:
  [[noreturn]] void fail(const std::string& reason) const { throw FileError(path_, {}, reason + "; export it again"); }
  [[noreturn]] void fail(const std::string& at, const char* key, const std::string& wanted) const {
    fail(at + (at.empty() ? "its " : ": its ") + in_quotes(key) + " should be " + wanted);
  }

  void check_asset() const {
    const GltfJson* asset = find_key(json_, "asset");
    const GltfJson* version = asset ? find_key(*asset, "version") : nullptr;
    if (version == nullptr || !version->is_string())
      fail("is not glTF: it has no \"asset\" with a \"version\", a string");
    for (const char* key : {"version", "minVersion"}) {
      const GltfJson* given = find_key(*asset, key);
      if (given == nullptr) continue;
      if (!given->is_string()) fail("asset", key, "a string");
      const std::string& text = given->get_ref<const std::string&>();
      if (!text.starts_with("2.") && text != "2") {
        throw FileError(path_, {},
                        "is glTF of version " + in_quotes(text) + "; only 2.0 can be read: export it as that");
      }
    }
    const GltfJson* needed = find_key(*asset, "minVersion");
    if (needed && *needed != "2.0" && *needed != "2") {
      throw FileError(path_, {},
                      "needs a reader of glTF " + in_quotes(needed->get<std::string>()) +
                          "; only 2.0 can be read: export it as that");
    }
  }

  void check_strings(const char* key) const {
    const GltfJson* array = find_key(json_, key);
    if (array == nullptr) return;
    const bool is_good = array->is_array() && std::all_of(array->begin(), array->end(),
                                                          [](const GltfJson& item) { return item.is_string(); });
    if (!is_good) fail("", key, "an array of strings");
  }

  void check_array_of_objects(const char* key) const {
    const GltfJson* array = find_key(json_, key);
    if (array == nullptr) return;
    if (!array->is_array()) fail("", key, "an array");
    for (std::size_t i = 0; i < array->size(); ++i) {
      if (!(*array)[i].is_object())
        fail("item " + std::to_string(i) + " of its " + in_quotes(key) + " should be an object");
    }
  }

  std::size_t size_of(const char* array) const {
    const GltfJson* found = find_key(json_, array);
    return found ? found->size() : 0;
  }

  template <typename Check>
  void each(const char* array, const char* noun, const Check& check) const {
    const GltfJson* items = find_key(json_, array);
    if (items == nullptr) return;
    for (std::size_t i = 0; i < items->size(); ++i) check(std::string(noun) + " " + std::to_string(i), (*items)[i]);
  }

  void required(const std::string& at, const GltfJson& object, const char* key) const {
    if (!find_key(object, key)) fail(at + ": it has no " + in_quotes(key));
  }

  void check_index(const std::string& at, const char* key, const GltfJson& value, const char* array) const {
    const std::size_t size = size_of(array);
    if (!value.is_number_integer()) fail(at, key, "a number of " + in_quotes(array));
    if (value.is_number_unsigned() && value.get<std::uint64_t>() < size) return;
    fail(at + (at.empty() ? "its " : ": its ") + in_quotes(key) + " names item " + value.dump() + " of " +
         in_quotes(array) + (size == 0 ? ", which has none" : ", which ends with item " + std::to_string(size - 1)));
  }
  void index(const std::string& at, const GltfJson& object, const char* key, const char* array) const {
    if (const GltfJson* value = find_key(object, key)) check_index(at, key, *value, array);
  }
  void indices(const std::string& at, const GltfJson& object, const char* key, const char* array) const {
    const GltfJson* values = find_key(object, key);
    if (values == nullptr) return;
    if (!values->is_array()) fail(at, key, "an array of numbers of " + in_quotes(array));
    for (const GltfJson& value : *values) check_index(at, key, value, array);
  }

  void numbers(const std::string& at, const GltfJson& object, const char* key, std::size_t count) const {
    const GltfJson* values = find_key(object, key);
    if (values == nullptr) return;
    const bool is_good =
        values->is_array() && values->size() == count &&
        std::all_of(values->begin(), values->end(), [](const GltfJson& value) { return number_in(value).has_value(); });
    if (!is_good) fail(at, key, std::to_string(count) + " finite numbers");
  }

  // A size or an offset.
  std::uint64_t whole(const std::string& at, const GltfJson& object, const char* key,
                      std::uint64_t largest = std::uint64_t{1} << 53) const {
    const GltfJson* value = find_key(object, key);
    if (value == nullptr) return 0;
    if (!value->is_number_unsigned() || value->get<std::uint64_t>() > largest) {
      fail(at, key, "a whole number from 0 to " + std::to_string(largest));
    }
    return value->get<std::uint64_t>();
  }

  void string(const std::string& at, const GltfJson& object, const char* key) const {
    const GltfJson* value = find_key(object, key);
    if (value && !value->is_string()) fail(at, key, "a string");
  }

  const GltfJson* object_in(const std::string& at, const GltfJson& object, const char* key) const {
    const GltfJson* value = find_key(object, key);
    if (value && !value->is_object()) fail(at, key, "an object");
    return value;
  }

  void check_node(const std::string& at, const GltfJson& node) const {
    string(at, node, "name");
    index(at, node, "mesh", "meshes");
    index(at, node, "skin", "skins");
    indices(at, node, "children", "nodes");
    numbers(at, node, "translation", 3);
    numbers(at, node, "rotation", 4);
    numbers(at, node, "scale", 3);
    numbers(at, node, "matrix", 16);
    object_in(at, node, "extensions");
  }

  void check_attributes(const std::string& at, const GltfJson& attributes) const {
    for (const auto& item : attributes.items()) check_index(at, item.key().c_str(), item.value(), "accessors");
  }

  void check_mesh(const std::string& at, const GltfJson& mesh) const {
    string(at, mesh, "name");
    const GltfJson* primitives = find_key(mesh, "primitives");
    if (primitives == nullptr || !primitives->is_array()) fail(at, "primitives", "an array");
    for (std::size_t i = 0; i < primitives->size(); ++i) {
      const GltfJson& primitive = (*primitives)[i];
      const std::string here = at + ", primitive " + std::to_string(i);
      if (!primitive.is_object()) fail(here + " should be an object");
      const GltfJson* attributes = object_in(here, primitive, "attributes");
      if (attributes) check_attributes(here, *attributes);
      index(here, primitive, "indices", "accessors");
      if (whole(here, primitive, "mode") > 6) fail(here, "mode", "0 to 6");
      const GltfJson* targets = find_key(primitive, "targets");
      if (targets && !targets->is_array()) fail(here, "targets", "an array");
      for (std::size_t k = 0; targets && k < targets->size(); ++k) {
        if (!(*targets)[k].is_object()) fail(here, "targets", "an array of objects");
        check_attributes(here, (*targets)[k]);
      }
    }
  }

  void component_type(const std::string& at, const GltfJson& object) const {
    constexpr std::array<std::uint64_t, 6> known = {5120, 5121, 5122, 5123, 5125, 5126};
    required(at, object, "componentType");
    const std::uint64_t type = whole(at, object, "componentType");
    if (std::find(known.begin(), known.end(), type) == known.end())
      fail(at, "componentType", "5120 to 5126, without 5124");
  }

  void check_accessor(const std::string& at, const GltfJson& accessor) const {
    constexpr std::array<std::string_view, 7> types = {"SCALAR", "VEC2", "VEC3", "VEC4", "MAT2", "MAT3", "MAT4"};
    index(at, accessor, "bufferView", "bufferViews");
    whole(at, accessor, "byteOffset");
    component_type(at, accessor);
    required(at, accessor, "count");
    whole(at, accessor, "count");
    const GltfJson* type = find_key(accessor, "type");
    const bool is_known = type && type->is_string() &&
                          std::find(types.begin(), types.end(), type->get_ref<const std::string&>()) != types.end();
    if (!is_known) fail(at, "type", "SCALAR, VEC2, VEC3, VEC4, MAT2, MAT3 or MAT4");
    if (const GltfJson* is_normalized = find_key(accessor, "normalized");
        is_normalized && !is_normalized->is_boolean()) {
      fail(at, "normalized", "true or false");
    }
    const std::uint64_t count = find_key(accessor, "count")->get<std::uint64_t>();
    if (const GltfJson* sparse = object_in(at, accessor, "sparse")) check_sparse(at, *sparse, count);
  }

  void check_sparse(const std::string& at, const GltfJson& sparse, std::uint64_t most) const {
    constexpr std::uint64_t largest = std::numeric_limits<std::int32_t>::max();  // that tinygltf can hold
    required(at + ", sparse", sparse, "count");
    whole(at + ", sparse", sparse, "count", std::min(most, largest));
    for (const char* key : {"indices", "values"}) {
      const std::string here = at + ", sparse " + key;
      const GltfJson* part = object_in(at + ", sparse", sparse, key);
      if (part == nullptr) fail(at + ", sparse: it has no " + in_quotes(key));
      required(here, *part, "bufferView");
      index(here, *part, "bufferView", "bufferViews");
      whole(here, *part, "byteOffset", largest);
      if (key == std::string_view("indices")) component_type(here, *part);
    }
  }

  void check_view(const std::string& at, const GltfJson& view) const {
    required(at, view, "buffer");
    index(at, view, "buffer", "buffers");
    required(at, view, "byteLength");
    const std::uint64_t end = whole(at, view, "byteOffset") + whole(at, view, "byteLength");
    const std::uint64_t stride = whole(at, view, "byteStride");
    if (stride % 4 != 0 || stride > 252) fail(at, "byteStride", "4 to 252 and a multiple of 4");
    const auto buffer = find_key(view, "buffer")->get<std::size_t>();
    const auto length = find_key((*find_key(json_, "buffers"))[buffer], "byteLength")->get<std::uint64_t>();
    if (end > length) {
      fail(at + ": it ends at byte " + std::to_string(end) + " of buffer " + std::to_string(buffer) + ", which has " +
           counted(length, "byte"));
    }
  }

  void check_animation(const std::string& at, const GltfJson& animation) const {
    const GltfJson* channels = find_key(animation, "channels");
    if (channels == nullptr) return;
    if (!channels->is_array()) fail(at, "channels", "an array");
    for (std::size_t i = 0; i < channels->size(); ++i) {
      const std::string here = at + ", channel " + std::to_string(i);
      const GltfJson* target = object_in(here, (*channels)[i], "target");
      if (target) index(here, *target, "node", "nodes");
    }
  }

  const std::filesystem::path& path_;
  const GltfJson& json_;
};

}  // namespace

void check_gltf(const std::filesystem::path& path, const GltfJson& json) { Checker(path, json).run(); }

}  // namespace cagewright::host
