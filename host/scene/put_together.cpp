// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "host/file/gltf_own_nodes.h"
#include "host/scene/cage_geometry.h"
#include "host/scene/own_extension.h"
#include "host/scene/scene_parts.h"
#include "host/scene/slide_transform.h"

namespace cagewright::host {
namespace {

bool same_ellipse(const Slide::Ellipse& a, const Slide::Ellipse& b) {
  return a.center == b.center && a.u == b.u && a.v == b.v;
}

void write_transform(const Eigen::Affine3d& transform, const std::optional<TranslationRotationScale>& parts,
                     GltfJson& node) {
  for (const char* key : {"translation", "rotation", "scale", "matrix"}) node.erase(key);
  if (parts) {
    const auto& p = *parts;
    node["translation"] = {p[0], p[1], p[2]};
    node["rotation"] = {p[3], p[4], p[5], p[6]};
    node["scale"] = {p[7], p[8], p[9]};
  } else {
    const Eigen::Matrix4d matrix = transform.matrix();
    node["matrix"] = std::vector<double>(matrix.data(), matrix.data() + matrix.size());
  }
}

class PuttingTogether {
 public:
  PuttingTogether(const std::filesystem::path& path, const SceneBase& base, const SceneContent& content)
      : path_(path), base_(base), content_(content), json_(base.json), holes_(base.holes) {}

  GltfJson run() {
    if (content_.slides.empty() && content_.cages.empty() && holes_.empty()) return std::move(json_);
    for (const SceneSlide& slide : content_.slides) claim(slide);
    for (const SceneCage& cage : content_.cages) claim(cage);
    for (const SceneSlide& slide : content_.slides) add(slide);
    const std::vector<int> meshes = attach_cage_geometry(path_, base_, content_, json_, filled_);
    for (std::size_t k = 0; k < meshes.size(); ++k) add(content_.cages[k], meshes[k]);
    drop_holes_at_the_end();
    name_extensions();
    if (first_own_ >= 0) write_keeps(kept_and_filled(), node(first_own_));
    return std::move(json_);
  }

 private:
  GltfJson& nodes() { return json_["nodes"]; }
  GltfJson& node(int index) { return nodes()[static_cast<std::size_t>(index)]; }

  template <typename Own>
  void claim(const Own& own) {
    if (own.as_read && own.as_read->home >= 0) holes_.erase(own.as_read->home);
  }

  // A place for a node: its own, an empty one, or a new one at the end.
  int place_for(int home) {
    if (home >= 0) return home;
    if (!holes_.empty()) return holes_.extract(holes_.begin()).value();
    nodes().push_back(nullptr);
    return static_cast<int>(nodes().size()) - 1;
  }

  void put(int index, GltfJson value) {
    node(index) = std::move(value);
    if (first_own_ < 0) first_own_ = index;
  }

  // Adds a node to its parent's children, or to the scenes where it has no parent.
  void link(int child, int parent) {
    GltfJson& children = node(parent)["children"];
    if (children.is_null()) {
      children = GltfJson::array();
    } else if (children.empty()) {
      filled_.insert("/nodes/" + std::to_string(parent) + "/children");
    }
    children.push_back(child);
  }

  void add(const SceneSlide& slide) {
    const SlideAsRead* read = slide.as_read.get();
    GltfJson value = GltfJson::object();
    if (read) value = read->is_pinned ? node(read->home) : read->node;
    value["name"] = slide.name;
    const bool is_adopted = !read || read->parent < 0;
    std::optional<TranslationRotationScale> fitted;
    if (is_adopted || !same_ellipse(slide.ellipse, read->ellipse)) {
      Eigen::Affine3d local = slide_transform(slide.ellipse);
      if (!is_adopted) local = read->parent_to_mesh.inverse() * local;
      fitted = decompose(local);
      write_transform(local, fitted, value);
    } else {
      fitted = transform_of(value);
    }
    write_slide_extension(slide, fitted, value);
    const int index = place_for(read ? read->home : -1);
    put(index, std::move(value));
    if (read == nullptr || !read->is_pinned) link(index, is_adopted ? slide.mesh_node : read->parent);
    has_slides_ = true;
  }

  // The parts of a node's transform as they are written; empty where it has a matrix.
  static std::optional<TranslationRotationScale> transform_of(const GltfJson& value) {
    if (find_key(value, "matrix")) return {};
    TranslationRotationScale parts = {0, 0, 0, 0, 0, 0, 1, 1, 1, 1};
    std::size_t at = 0;
    for (const auto& [key, count] : {std::pair{"translation", 3}, std::pair{"rotation", 4}, std::pair{"scale", 3}}) {
      const GltfJson* array = find_key(value, key);
      for (int i = 0; i < count; ++i, ++at) {
        if (array && array->is_array() && array->size() == static_cast<std::size_t>(count)) {
          parts[at] = number_in((*array)[static_cast<std::size_t>(i)]).value_or(parts[at]);
        }
      }
    }
    return parts;
  }

  void add(const SceneCage& cage, int mesh) {
    const CageAsRead* read = cage.as_read.get();
    GltfJson value = read ? read->node : GltfJson::object();
    if (!cage.name.empty()) value["name"] = cage.name;
    value["mesh"] = mesh;
    write_cage_extension(cage, cage.mesh_node, value);
    const int index = place_for(read ? read->home : -1);
    put(index, std::move(value));
    link(index, read && read->parent >= 0 ? read->parent : cage.mesh_node);
    has_cages_ = true;
  }

  void drop_holes_at_the_end() {
    while (!holes_.empty() && *holes_.rbegin() == static_cast<int>(nodes().size()) - 1) {
      nodes().erase(nodes().size() - 1);
      holes_.erase(std::prev(holes_.end()));
    }
  }

  void name_extensions() {
    if (!has_slides_ && !has_cages_) return;
    GltfJson& used = json_["extensionsUsed"];
    if (used.is_null()) {
      used = GltfJson::array();
    } else if (used.empty()) {
      filled_.insert("/extensionsUsed");
    }
    if (has_slides_) used.push_back(slide_extension);
    if (has_cages_) used.push_back(cage_extension);
  }

  std::set<std::string> kept_and_filled() const {
    std::set<std::string> all = base_.keeps;
    all.insert(filled_.begin(), filled_.end());
    return all;
  }

  const std::filesystem::path& path_;
  const SceneBase& base_;
  const SceneContent& content_;
  GltfJson json_;
  std::set<int> holes_;
  std::set<std::string> filled_;  // arrays that were there and empty
  int first_own_ = -1;
  bool has_slides_ = false, has_cages_ = false;
};

}  // namespace

GltfJson put_together(const std::filesystem::path& path, const SceneBase& base, const SceneContent& content) {
  return PuttingTogether(path, base, content).run();
}

}  // namespace cagewright::host
