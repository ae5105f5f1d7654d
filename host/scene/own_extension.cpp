// SPDX-License-Identifier: BSD-3-Clause
#include "host/scene/own_extension.h"

#include <cmath>

#include "host/file/file_error.h"
#include "host/file/gltf_own_nodes.h"

namespace cagewright::host {
namespace {

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
  std::int64_t id_in(const GltfJson& json, const char* key, const char* wanted) const {
    const double id = number_in(json).value_or(0);
    if (!(id >= 1 && id <= static_cast<double>(largest_slide_id)) || id != std::floor(id)) fail(key, wanted);
    return static_cast<std::int64_t>(id);
  }

  std::vector<std::string> keeps() const {
    std::vector<std::string> pointers;
    if (const GltfJson* found = array("keeps", "an array of strings")) {
      for (const GltfJson& pointer : *found) {
        if (!pointer.is_string()) fail("keeps", "an array of strings");
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

// The extension's object, and the shadow where `extras` are free for it.
void write_own(const char* extension, GltfJson value, GltfJson shadow, GltfJson& node) {
  object_at(node, "extensions")[extension] = std::move(value);
  const GltfJson* extras = find_key(node, "extras");
  if (extras == nullptr || extras->is_object()) object_at(node, "extras")[extension] = std::move(shadow);
}

}  // namespace

std::int64_t free_slide_id(const std::set<std::int64_t>& taken) {
  if (taken.empty()) return 1;
  if (*taken.rbegin() < largest_slide_id) return *taken.rbegin() + 1;
  std::int64_t id = 1;
  while (taken.count(id) > 0) ++id;
  return id;
}

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
  own.keeps = reader.keeps();
  return own;
}

SceneCage read_cage_extension(const std::filesystem::path& path, const std::string& place, const GltfJson& node,
                              std::set<std::string>& keeps) {
  const OwnReader reader(path, place, cage_extension, node);
  SceneCage cage;
  if (const GltfJson* source = reader.find("source"); source && !source->is_number_integer()) {
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
      const bool is_row = row.is_number_integer() && row.get<std::int64_t>() >= -1 &&
                          row.get<std::int64_t>() < static_cast<std::int64_t>(cage.slides.size());
      if (!is_row) reader.fail("sections", "an array of rows of \"slides\", or -1");
      cage.sections.push_back(row.get<int>());
    }
  }
  if (const GltfJson* certificate = reader.find("certificate")) {
    if (!certificate->is_object()) reader.fail("certificate", "an object");
    cage.certificate = gltf_json_text(*certificate);
  }
  for (std::string& pointer : reader.keeps()) keeps.insert(std::move(pointer));
  return cage;
}

void write_slide_extension(const SceneSlide& slide, const std::optional<TranslationRotationScale>& fitted,
                           GltfJson& node) {
  GltfJson own = {{"id", slide.id}};
  if (!slide.stroke.empty() && fitted) {
    own["stroke"] = slide.stroke;
    own["fitted"] = *fitted;
  }
  write_own(slide_extension, std::move(own), {{"id", slide.id}}, node);
}

void write_cage_extension(const SceneCage& cage, int source, GltfJson& node) {
  GltfJson own = {{"source", source}, {"parameters", GltfJson::object()}};
  for (const auto& [id, value] : cage.parameters) own["parameters"][id] = value;
  own["slides"] = cage.slides;
  own["sections"] = cage.sections;
  if (!cage.certificate.empty()) own["certificate"] = parse_gltf_json({}, cage.certificate);
  write_own(cage_extension, std::move(own), {{"slides", cage.slides}}, node);
}

void write_keeps(const std::set<std::string>& keeps, GltfJson& node) {
  GltfJson& extensions = node["extensions"];
  for (const char* extension : {slide_extension, cage_extension}) {
    GltfJson* own = find_key(extensions, extension);
    if (own == nullptr) continue;
    own->erase("keeps");
    if (!keeps.empty()) (*own)["keeps"] = keeps;
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
