// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <map>

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

void write_transform(const TranslationRotationScale& p, GltfJson& node) {
  for (const char* key : {"translation", "rotation", "scale", "matrix"}) node.erase(key);
  node["translation"] = {p[0], p[1], p[2]};
  node["rotation"] = {p[3], p[4], p[5], p[6]};
  node["scale"] = {p[7], p[8], p[9]};
}

// The transform under the parent that it was read with; empty where glTF cannot say it, as shears between that parent
// and the mesh node would have to be undone.
std::optional<TranslationRotationScale> under_parent(const SlideAsRead& read, const Eigen::Affine3d& transform) {
  const Eigen::Affine3d local = read.parent_to_mesh.inverse() * transform;  // not finite where there is no inverse
  const double error = ((read.parent_to_mesh * local).matrix() - transform.matrix()).norm();
  return error <= 1e-9 * transform.matrix().norm() ? decompose(local) : std::nullopt;
}

class PuttingTogether {
 public:
  PuttingTogether(const std::filesystem::path& path, const SceneBase& base, const SceneContent& content)
      : path_(path), base_(base), content_(content), json_(base.json), holes_(base.holes) {}

  GltfJson run() {
    if (find_key(json_, "nodes") == nullptr) return std::move(json_);
    for (const SceneSlide& slide : content_.slides) {
      claim(slide);
      const SlideAsRead* read = slide.as_read.get();
      if (read && read->home >= 0 && !same_ellipse(slide.ellipse, read->ellipse)) moved_.insert(read->home);
    }
    for (const SceneCage& cage : content_.cages) claim(cage);
    for (const SceneSlide& slide : content_.slides) add(slide);
    const std::vector<int> meshes = attach_cage_geometry(path_, base_, content_, json_, filled_);
    for (std::size_t k = 0; k < meshes.size(); ++k) add(content_.cages[k], meshes[k]);
    link_children();
    drop_holes_at_the_end();
    name_extensions();
    if (first_own_ >= 0) write_keeps(filled_, node(first_own_));
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
    first_own_ = first_own_ < 0 ? index : std::min(first_own_, index);
  }

  // Adds our nodes to their parents' children: by number, so that a file that is read and written again stays the same.
  void link_children() {
    for (const auto& [child, parent] : parents_) {
      GltfJson& children = node(parent)["children"];
      if (children.is_null()) {
        children = GltfJson::array();
      } else if (children.empty()) {
        filled_.insert("/nodes/" + std::to_string(parent) + "/children");
      }
      children.push_back(child);
    }
  }

  // The node that was read, with the children that are in its place now.
  template <typename AsRead>
  GltfJson node_of(const AsRead& read) {
    GltfJson value = read.node;
    if (!read.is_pinned) return value;
    if (const GltfJson* children = find_key(node(read.home), "children")) {
      value["children"] = *children;
    } else {
      value.erase("children");
    }
    return value;
  }

  void add(const SceneSlide& slide) {
    const SlideAsRead* read = slide.as_read.get();
    const Eigen::Affine3d transform = slide_transform(slide.ellipse);
    // A slide that a tool has put below another one does not move with it.
    const bool is_carried = read && std::any_of(read->carriers.begin(), read->carriers.end(),
                                                [this](int carrier) { return moved_.count(carrier) > 0; });
    const bool is_unchanged =
        read && same_ellipse(slide.ellipse, read->ellipse) && (slide.stroke.empty() || read->fitted) && !is_carried;
    const auto fitted = is_unchanged ? read->fitted : decompose(transform);
    bool keeps_parent = read && (read->parent >= 0 || read->is_pinned) && !is_carried;
    std::optional<TranslationRotationScale> local;
    if (keeps_parent && !is_unchanged) {
      local = under_parent(*read, transform);
      keeps_parent = local.has_value();
    }
    if (!keeps_parent) {
      local = decompose(transform);
      if (read && read->is_pinned) read = nullptr;  // its old node stays with what others have put there
    }
    GltfJson value = read ? node_of(*read) : GltfJson::object();
    value["name"] = slide.name;
    if (local) write_transform(*local, value);
    write_slide_extension(slide, fitted, value);
    const int index = place_for(read ? read->home : -1);
    put(index, std::move(value));
    if (!read || !read->is_pinned) parents_[index] = keeps_parent ? read->parent : slide.mesh_node;
  }

  void add(const SceneCage& cage, int mesh) {
    const CageAsRead* read = cage.as_read.get();
    GltfJson value = read ? node_of(*read) : GltfJson::object();
    if (!cage.name.empty()) value["name"] = cage.name;
    value["mesh"] = mesh;
    write_cage_extension(cage, cage.mesh_node, value);
    const int index = place_for(read ? read->home : -1);
    put(index, std::move(value));
    if (!read || !read->is_pinned) parents_[index] = read ? read->parent : cage.mesh_node;
  }

  void drop_holes_at_the_end() {
    while (!holes_.empty() && *holes_.rbegin() == static_cast<int>(nodes().size()) - 1) {
      nodes().erase(nodes().size() - 1);
      holes_.erase(std::prev(holes_.end()));
    }
  }

  // Also where a node of ours has stayed with the others, as a second cage has.
  void name_extensions() {
    for (const char* name : {slide_extension, cage_extension}) {
      const auto has_it = [name](const GltfJson& each) {
        const GltfJson* extensions = find_key(each, "extensions");
        return extensions && find_key(*extensions, name);
      };
      if (std::none_of(nodes().begin(), nodes().end(), has_it)) continue;
      GltfJson& used = json_["extensionsUsed"];
      if (used.is_null()) {
        used = GltfJson::array();
      } else if (used.empty()) {
        filled_.insert("/extensionsUsed");
      }
      used.push_back(name);
    }
  }

  const std::filesystem::path& path_;
  const SceneBase& base_;
  const SceneContent& content_;
  GltfJson json_;
  std::set<int> holes_;
  std::set<int> moved_;           // places of slides that have another transform by now
  std::set<std::string> filled_;  // arrays that were there and empty
  std::map<int, int> parents_;    // of our nodes, but for those that have stayed where they were
  int first_own_ = -1;
};

}  // namespace

GltfJson put_together(const std::filesystem::path& path, const SceneBase& base, const SceneContent& content) {
  return PuttingTogether(path, base, content).run();
}

}  // namespace cagewright::host
