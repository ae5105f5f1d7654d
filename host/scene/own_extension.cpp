// SPDX-License-Identifier: BSD-3-Clause
#include "host/scene/own_extension.h"

#include <algorithm>
#include <cmath>

#include "host/file/file_error.h"
#include "host/file/gltf_own_nodes.h"
#include "host/scene/slide_ids.h"

namespace cagewright::host {
namespace {

constexpr char keeps_key[] = "keeps", source_name_key[] = "source_name", source_mesh_key[] = "source_mesh",
               source_pose_key[] = "source_pose";

// Reads one extension's object; every refusal names the node and the key.
class OwnReader {
 public:
  OwnReader(const std::filesystem::path& path, std::string place, const char* extension, const GltfJson& node)
      : path_(path), place_(std::move(place)), extension_(extension) {
    for (const char* holder : {"extensions", "extras"}) {
      const GltfJson* all = find_key(node, holder);
      const GltfJson* own = all ? find_key(*all, extension) : nullptr;
      if (own == nullptr) continue;
      if (!own->is_object()) fail("", "an object");
      own_ = own;
      return;
    }
  }

  [[noreturn]] void fail(const std::string& key, const std::string& wanted) const {
    throw FileError(path_, {},
                    place_ + extension_ + (key.empty() ? "" : "." + key) + " should be " + wanted +
                        "; mend it, or take it out of the node");
  }

  const GltfJson* find(const char* key) const { return own_ ? find_key(*own_, key) : nullptr; }

  // Null where the key is not there.
  const GltfJson* array(const char* key, const char* wanted) const {
    const GltfJson* found = find(key);
    if (found && !found->is_array()) fail(key, wanted);
    return found;
  }

  // Tools whose numbers are all doubles write 3.0 for 3.
  std::optional<std::int64_t> whole(const GltfJson& json) const {
    const auto number = number_in(json);
    if (!number || *number != std::floor(*number) || std::abs(*number) > static_cast<double>(largest_slide_id))
      return {};
    return static_cast<std::int64_t>(*number);
  }

  std::int64_t id_in(const GltfJson& json, const char* key, const char* wanted) const {
    const std::int64_t id = whole(json).value_or(0);
    if (id < 1) fail(key, wanted);
    return id;
  }

  std::string text(const char* key) const {
    const GltfJson* found = find(key);
    if (found && !found->is_string()) fail(key, "a string");
    return found ? found->get<std::string>() : "";
  }
  std::optional<Eigen::Affine3d> pose() const {
    const GltfJson* found = array(source_pose_key, "16 numbers");
    if (found == nullptr) return {};
    if (found->size() != 16) fail(source_pose_key, "16 numbers");
    Eigen::Matrix4d matrix;
    for (Eigen::Index i = 0; i < 16; ++i) {
      const auto number = number_in((*found)[static_cast<std::size_t>(i)]);
      if (!number) fail(source_pose_key, "16 numbers");
      matrix.data()[i] = *number;
    }
    return Eigen::Affine3d(matrix);
  }

  SourceNames source() const { return {text(source_name_key), text(source_mesh_key)}; }

  std::vector<std::string> keeps() const {
    std::vector<std::string> pointers;
    if (const GltfJson* found = array(keeps_key, "an array of strings")) {
      for (const GltfJson& pointer : *found) {
        if (!pointer.is_string()) fail(keeps_key, "an array of strings");
        pointers.push_back(pointer.get<std::string>());
      }
    }
    return pointers;
  }

 private:
  const std::filesystem::path& path_;
  std::string place_;
  const char* extension_;
  const GltfJson* own_ = nullptr;
};

GltfJson& object_at(GltfJson& node, const char* key) {
  GltfJson* found = find_key(node, key);
  if (found && found->is_object()) return *found;
  return node[key] = GltfJson::object();
}

// Whether two values say the same, however their numbers are written.
bool say_the_same(const GltfJson& a, const GltfJson& b) {
  if (const auto number = number_in(a)) return number == number_in(b);
  if (a.type() != b.type() || a.size() != b.size()) return false;
  if (a.is_array()) return std::equal(a.begin(), a.end(), b.begin(), say_the_same);
  if (!a.is_object()) return a == b;
  for (const auto& [key, value] : a.items()) {
    const GltfJson* other = find_key(b, key);
    if (other == nullptr || !say_the_same(value, *other)) return false;
  }
  return true;
}

// The keys that are ours get these values, or go where they have none.
void merge(const char* extension, const std::vector<const char*>& own_keys, const GltfJson& values, GltfJson& holder) {
  GltfJson& own = object_at(holder, extension);
  for (const char* key : own_keys) {
    const GltfJson* value = find_key(values, key);
    if (value == nullptr) {
      own.erase(key);
    } else if (const GltfJson* before = find_key(own, key); before == nullptr || !say_the_same(*before, *value)) {
      own[key] = *value;
    }
  }
}

// The extension's object, and the shadow where `extras` are free for it.
void write_own(const char* extension, const std::vector<const char*>& own_keys, const GltfJson& values,
               const std::vector<const char*>& shadow_keys, GltfJson& node) {
  merge(extension, own_keys, values, object_at(node, "extensions"));
  const GltfJson* extras = find_key(node, "extras");
  if (extras && !extras->is_object()) return;
  merge(extension, shadow_keys, values, object_at(node, "extras"));
}

void add_source(const SourceNode& source, GltfJson& values) {
  if (!source.names.node.empty()) values[source_name_key] = source.names.node;
  if (!source.names.mesh.empty()) values[source_mesh_key] = source.names.mesh;
  if (source.pose) values[source_pose_key] = std::vector<double>(source.pose->data(), source.pose->data() + 16);
}

}  // namespace

OwnSlideExtension read_slide_extension(const std::filesystem::path& path, const std::string& place,
                                       const GltfJson& node) {
  const OwnReader reader(path, place, slide_extension, node);
  OwnSlideExtension own;
  const GltfJson* id = reader.find("id");
  if (id == nullptr) reader.fail("id", "there, a positive integer");
  own.id = reader.id_in(*id, "id", "a positive integer");
  if (const GltfJson* stroke = reader.array("stroke", "an array of points")) {
    for (const GltfJson& item : *stroke) {
      if (!item.is_array() || item.size() != 3) reader.fail("stroke", "an array of points, three numbers each");
      Point3 point{};
      for (std::size_t i = 0; i < 3; ++i) {
        const auto number = number_in(item[i]);
        if (!number) reader.fail("stroke", "an array of points, three numbers each");
        point[i] = *number;
      }
      own.stroke.push_back(point);
    }
  }
  if (const GltfJson* fitted = reader.array("fitted", "10 numbers")) {
    if (fitted->size() != 10) reader.fail("fitted", "10 numbers");
    own.fitted.emplace();
    for (std::size_t i = 0; i < 10; ++i) {
      const auto number = number_in((*fitted)[i]);
      if (!number) reader.fail("fitted", "10 numbers");
      (*own.fitted)[i] = *number;
    }
  }
  own.source = reader.source();
  own.pose = reader.pose();
  own.keeps = reader.keeps();
  return own;
}

OwnCageExtension read_cage_extension(const std::filesystem::path& path, const std::string& place,
                                     const GltfJson& node) {
  const OwnReader reader(path, place, cage_extension, node);
  SceneCage cage;
  if (const GltfJson* source = reader.find("source"); source && !reader.whole(*source)) {
    reader.fail("source", "the number of a node");
  }
  if (const GltfJson* parameters = reader.find("parameters")) {
    if (!parameters->is_object()) reader.fail("parameters", "an object of numbers");
    for (const auto& item : parameters->items()) {
      const auto number = number_in(item.value());
      if (!number) reader.fail("parameters", "an object of numbers");
      cage.parameters.emplace_back(item.key(), *number);
    }
  }
  if (const GltfJson* slides = reader.array("slides", "an array of ids")) {
    for (const GltfJson& id : *slides) cage.slides.push_back(reader.id_in(id, "slides", "an array of ids"));
  }
  if (const GltfJson* sections = reader.array("sections", "an array of rows of \"slides\", or -1")) {
    for (const GltfJson& row : *sections) {
      const auto section = reader.whole(row);
      const bool is_row = section && *section >= -1 && *section < static_cast<std::int64_t>(cage.slides.size());
      if (!is_row) reader.fail("sections", "an array of rows of \"slides\", or -1");
      cage.sections.push_back(static_cast<int>(*section));
    }
  }
  if (const GltfJson* certificate = reader.find("certificate")) {
    if (!certificate->is_object()) reader.fail("certificate", "an object");
    cage.certificate = gltf_json_text(*certificate);
  }
  return {std::move(cage), reader.source(), reader.pose(), reader.keeps()};
}

void write_slide_extension(const SceneSlide& slide, const SourceNode& source,
                           const std::optional<TranslationRotationScale>& fitted, GltfJson& node) {
  GltfJson values = {{"id", slide.id}};
  add_source(source, values);
  if (!slide.stroke.empty() && fitted) {
    values["stroke"] = slide.stroke;
    values["fitted"] = *fitted;
  }
  write_own(slide_extension, {"id", source_name_key, source_mesh_key, source_pose_key, "stroke", "fitted", keeps_key},
            values, {"id", source_name_key, source_mesh_key, source_pose_key}, node);
}

void write_cage_extension(const SceneCage& cage, const SourceNode& source, GltfJson& node) {
  GltfJson values = {{"source", source.node}, {"parameters", GltfJson::object()}};
  add_source(source, values);
  for (const auto& [id, value] : cage.parameters) values["parameters"][id] = value;
  values["slides"] = cage.slides;
  values["sections"] = cage.sections;
  if (!cage.certificate.empty()) values["certificate"] = parse_gltf_json({}, cage.certificate);
  write_own(cage_extension,
            {"source", source_name_key, source_mesh_key, source_pose_key, "parameters", "slides", "sections",
             "certificate", keeps_key},
            values, {source_name_key, source_mesh_key, source_pose_key, "slides"}, node);
}

void write_keeps(const std::set<std::string>& keeps, GltfJson& node) {
  GltfJson& extensions = node["extensions"];
  for (const char* extension : {slide_extension, cage_extension}) {
    GltfJson* own = find_key(extensions, extension);
    if (own == nullptr) continue;
    if (!keeps.empty()) (*own)[keeps_key] = keeps;
    return;
  }
}

void remove_own_extensions(GltfJson& node) {
  for (const char* holder : {"extensions", "extras"}) {
    GltfJson* all = find_key(node, holder);
    if (all == nullptr || !all->is_object()) continue;
    const std::size_t had = all->size();
    all->erase(slide_extension);
    all->erase(cage_extension);
    if (all->empty() && had > 0) node.erase(holder);
  }
}

}  // namespace cagewright::host
