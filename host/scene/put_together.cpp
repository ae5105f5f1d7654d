// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <map>
#include <tuple>

#include "host/file/gltf_own_nodes.h"
#include "host/scene/cage_geometry.h"
#include "host/scene/own_extension.h"
#include "host/scene/scene_parts.h"
#include "host/scene/slide_transform.h"

namespace cagewright::host {
namespace {

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
    if (find_key(json_, "nodes") != nullptr) {
      for (const SceneSlide& slide : content_.slides) claim(slide);
      for (const SceneCage& cage : content_.cages) claim(cage);
      for (const SceneStray& stray : content_.strays) claim(stray);
      for (const SceneSlide& slide : content_.slides) add(slide);
      add_cages();
      link_children();
      drop_empty_shells();
      drop_holes_at_the_end();
      name_extensions();
      if (first_own_ >= 0) write_keeps(filled_, node(first_own_));
    }
    for (const std::string& pointer : base_.drops) drop(pointer);
    return std::move(json_);
  }

 private:
  GltfJson& nodes() { return json_["nodes"]; }
  GltfJson& node(int index) { return nodes()[static_cast<std::size_t>(index)]; }

  template <typename Own>
  void claim(const Own& own) {
    if (own.as_read && own.as_read->home >= 0) holes_.erase(own.as_read->home);
  }
  void claim(const SceneSlide& slide) {
    const SlideAsRead* read = slide.as_read.get();
    if (read == nullptr || read->home < 0) return;
    holes_.erase(read->home);
    if (slide.ellipse != read->ellipse) moved_.insert(read->home);
  }

  // Whether a slide above has another transform by now; what a tool has put below it does not move with it.
  bool is_carried(const NodeAsRead* read) {
    std::vector<int> way;
    for (int carrier = read ? read->carrier : -1; carrier >= 0;) {
      const auto known = carries_.find(carrier);
      const bool carries = known != carries_.end() ? known->second : moved_.count(carrier) > 0;
      if (known != carries_.end() || carries) {
        for (const int below : way) carries_[below] = carries;
        carries_[carrier] = carries;
        return carries;
      }
      way.push_back(carrier);
      const auto next = base_.carriers.find(carrier);
      carrier = next == base_.carriers.end() ? -1 : next->second;
    }
    for (const int carrier : way) carries_[carrier] = false;
    return false;
  }

  // A place for a node: its own, an empty one, or a new one at the end.
  int place_for(int home) {
    if (home >= 0) return home;
    if (!holes_.empty()) return holes_.extract(holes_.begin()).value();
    nodes().push_back(nullptr);
    return static_cast<int>(nodes().size()) - 1;
  }

  int put(const NodeAsRead* read, GltfJson value, int parent) {
    const int index = place_for(read ? read->home : -1);
    owned_.insert(index);
    node(index) = std::move(value);
    if (!read || !read->is_pinned) parents_[index] = parent;
    return index;
  }
  void put_own(const NodeAsRead* read, GltfJson value, int parent) {
    const int index = put(read, std::move(value), parent);
    first_own_ = first_own_ < 0 ? index : std::min(first_own_, index);
  }

  void note_filled(const std::string& pointer) {
    if (base_.drops.count(pointer) == 0) filled_.insert(pointer);
  }

  // Adds our nodes to their parents' children: by number, so that a file that is read and written again stays the same.
  void link_children() {
    for (const auto& [child, parent] : parents_) {
      if (parent < 0) continue;
      GltfJson& children = node(parent)["children"];
      if (children.is_null()) {
        children = GltfJson::array();
      } else if (children.empty()) {
        note_filled("/nodes/" + std::to_string(parent) + "/children");
      }
      children.push_back(child);
    }
    link_roots();
  }

  void link_roots() {
    std::sort(roots_.begin(), roots_.end());
    std::map<int, int> inserted;
    for (const auto& [scene, place, child] : roots_) {
      GltfJson& roots = json_["scenes"][static_cast<std::size_t>(scene)]["nodes"];
      roots.insert(roots.begin() + place + inserted[scene]++, child);
    }
  }

  // The node that was read, with the children that are in its place now.
  GltfJson node_of(const NodeAsRead& read) {
    GltfJson value = read.node;
    if (!read.is_pinned) return value;
    if (const GltfJson* children = find_key(node(read.home), "children")) {
      value["children"] = *children;
    } else {
      value.erase("children");
    }
    return value;
  }

  SourceNode source_of(int mesh_node) {
    const auto name_in = [](const GltfJson& object) {
      const GltfJson* name = find_key(object, "name");
      return name && name->is_string() ? name->get<std::string>() : "";
    };
    const GltfJson* mesh = find_key(node(mesh_node), "mesh");
    const auto pose = base_.poses.find(mesh_node);
    return {mesh_node,
            {name_in(node(mesh_node)), name_in(json_["meshes"][mesh->get<std::size_t>()])},
            pose == base_.poses.end() ? std::nullopt : std::optional(pose->second)};
  }

  void add(const SceneSlide& slide) {
    const SlideAsRead* read = slide.as_read.get();
    const Eigen::Affine3d transform = slide_transform(slide.ellipse);
    const bool carried = is_carried(read);
    const bool is_unchanged =
        read && slide.ellipse == read->ellipse && (slide.stroke.empty() || read->fitted) && !carried;
    const auto in_mesh_space = slide.numbers ? slide.numbers : decompose(transform);
    const auto fitted = is_unchanged ? read->fitted : in_mesh_space;
    bool keeps_parent = read && (read->parent >= 0 || read->is_pinned) && !carried;
    std::optional<TranslationRotationScale> local;
    if (keeps_parent && !is_unchanged) {
      const bool is_of_mesh = read->parent_to_mesh.matrix() == Eigen::Affine3d::Identity().matrix();
      local = is_of_mesh ? in_mesh_space : under_parent(*read, transform);
      keeps_parent = local.has_value();
    }
    if (!keeps_parent) {
      local = in_mesh_space;
      if (read && read->is_pinned) read = nullptr;  // its old node stays with what others have put there
    }
    GltfJson value = read ? node_of(*read) : GltfJson::object();
    value["name"] = slide.name;
    if (local) write_transform(*local, value);
    write_slide_extension(slide, source_of(slide.mesh_node), fitted, value);
    put_own(read, std::move(value), keeps_parent ? read->parent : slide.mesh_node);
  }

  void add_cages() {
    std::vector<bool> is_new;
    for (const SceneCage& cage : content_.cages) is_new.push_back(!cage.is_as_read || is_carried(cage.as_read.get()));
    const CageMeshes meshes = attach_cage_geometry(path_, base_, content_, is_new, json_, filled_);
    for (std::size_t k = 0; k < content_.cages.size(); ++k) add(content_.cages[k], is_new[k], meshes.cages[k]);
    for (std::size_t k = 0; k < content_.strays.size(); ++k) add(content_.strays[k], meshes.strays[k]);
  }

  // A new geometry is in the mesh node's space, so its node has no transform and no skin.
  void add(const SceneCage& cage, bool is_new, int mesh) {
    const CageAsRead* read = cage.as_read.get();
    const bool keeps_parent = read && (!is_new || (!read->is_elsewhere && !is_carried(read)));
    if (read && read->is_pinned && !keeps_parent) read = nullptr;  // as for slides
    GltfJson value = read ? node_of(*read) : GltfJson::object();
    if (is_new) {
      for (const char* key : {"skin", "weights"}) value.erase(key);
      if (!keeps_parent) {
        for (const char* key : {"translation", "rotation", "scale", "matrix"}) value.erase(key);
      }
    }
    if (!cage.name.empty()) value["name"] = cage.name;
    value["mesh"] = mesh;
    write_cage_extension(cage, source_of(cage.mesh_node), value);
    put_own(read, std::move(value), keeps_parent ? read->parent : cage.mesh_node);
  }

  void add(const SceneStray& stray, int mesh) {
    const CageAsRead& read = *stray.as_read;
    GltfJson value = node_of(read);
    if (mesh >= 0) value["mesh"] = mesh;
    const int index = put(&read, std::move(value), read.parent);
    for (const auto& [scene, place] : read.roots) roots_.emplace_back(scene, place, index);
  }

  void drop_empty_shells() {
    for (const auto& [shell, parent] : base_.shells) {
      for (int here = shell; is_empty_shell(here); here = base_.shells.at(here)) unlink(here, base_.shells.at(here));
    }
  }

  bool is_empty_shell(int index) {
    if (base_.shells.count(index) == 0 || owned_.count(index) > 0 || holes_.count(index) > 0) return false;
    const GltfJson* children = find_key(node(index), "children");
    return !children || children->empty();
  }

  void unlink(int shell, int parent) {
    const auto remove_from = [shell](GltfJson& holder, const char* key) {
      GltfJson* items = find_key(holder, key);
      if (items == nullptr || !items->is_array()) return;
      const auto found = std::find(items->begin(), items->end(), shell);
      if (found == items->end()) return;
      items->erase(found);
      if (items->empty()) holder.erase(key);
    };
    GltfJson* scenes = find_key(json_, "scenes");
    if (parent >= 0) {
      remove_from(node(parent), "children");
    } else if (scenes != nullptr) {
      for (GltfJson& scene : *scenes) remove_from(scene, "nodes");
    }
    node(shell) = GltfJson::object();
    holes_.insert(shell);
  }

  void drop_holes_at_the_end() {
    while (!holes_.empty() && *holes_.rbegin() == static_cast<int>(nodes().size()) - 1) {
      nodes().erase(nodes().size() - 1);
      holes_.erase(std::prev(holes_.end()));
    }
  }

  // In their old places where they are named already.
  void name_extensions() {
    for (const char* name : {slide_extension, cage_extension}) {
      const auto has_it = [name](const GltfJson& each) {
        const GltfJson* extensions = find_key(each, "extensions");
        return extensions && find_key(*extensions, name);
      };
      const bool is_used = std::any_of(nodes().begin(), nodes().end(), has_it);
      GltfJson* used = find_key(json_, "extensionsUsed");
      if (used == nullptr) {
        if (is_used) json_["extensionsUsed"] = GltfJson::array({name});
        continue;
      }
      const auto found = std::find(used->begin(), used->end(), name);
      if (is_used && found == used->end()) {
        used->push_back(name);
      } else if (!is_used && found != used->end()) {
        used->erase(std::remove(found, used->end(), GltfJson(name)), used->end());
        if (used->empty() && base_.keeps.count("/extensionsUsed") == 0) json_.erase("extensionsUsed");
      }
    }
    const GltfJson* others = find_key(base_.json, "extensionsUsed");
    const bool was_empty = others && std::all_of(others->begin(), others->end(), [](const GltfJson& name) {
                             return name.is_string() && is_own_extension(name.get_ref<const std::string&>());
                           });
    if (was_empty && (others->empty() || base_.keeps.count("/extensionsUsed") > 0)) filled_.insert("/extensionsUsed");
  }

  void drop(const std::string& pointer) {
    const GltfJson::json_pointer at(pointer);
    if (json_.contains(at) && json_.at(at).empty()) json_.at(at.parent_pointer()).erase(at.back());
  }

  const std::filesystem::path& path_;
  const SceneBase& base_;
  const SceneContent& content_;
  GltfJson json_;
  std::set<int> holes_;
  std::set<int> moved_;                           // places of slides that have another transform by now
  std::set<int> owned_;                           // places of ours
  std::map<int, bool> carries_;                   // of places of slides: whether they or one above have moved
  std::set<std::string> filled_;                  // arrays that were there and empty
  std::map<int, int> parents_;                    // of our nodes, but for those that have stayed where they were
  std::vector<std::tuple<int, int, int>> roots_;  // of strays: scene, roots of others before it, number
  int first_own_ = -1;
};

}  // namespace

GltfJson put_together(const std::filesystem::path& path, const SceneBase& base, const SceneContent& content) {
  return PuttingTogether(path, base, content).run();
}

}  // namespace cagewright::host
