// SPDX-License-Identifier: BSD-3-Clause
#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "host/file/file_error.h"
#include "host/file/gltf_geometry.h"
#include "host/file/gltf_nodes.h"
#include "host/file/gltf_own_nodes.h"
#include "host/scene/cage_geometry.h"
#include "host/scene/own_extension.h"
#include "host/scene/scene_parts.h"
#include "host/scene/slide_transform.h"

namespace cagewright::host {
namespace {

// Whether a node's transform is still the one that its stroke was fitted to, but for the rounding of a tool that keeps
// floats.
bool agrees(const Eigen::Affine3d& transform, const TranslationRotationScale& fitted) {
  Eigen::Affine3d then = Eigen::Affine3d::Identity();
  then.translate(Eigen::Vector3d(fitted[0], fitted[1], fitted[2]));
  then.rotate(Eigen::Quaterniond(fitted[6], fitted[3], fitted[4], fitted[5]).normalized());
  then.scale(Eigen::Vector3d(fitted[7], fitted[8], fitted[9]));
  const double size = then.linear().norm() + then.translation().norm();
  return (transform.matrix() - then.matrix()).norm() <= 1e-6 * size;
}

class TakingApart {
 public:
  TakingApart(const std::filesystem::path& path, GltfJson json, const tinygltf::Model& model)
      : path_(path), model_(model), parents_(gltf_parents(path, model)) {
    result_.base.json = std::move(json);
  }

  TakenApart run() {
    GltfJson* nodes = find_key(result_.base.json, "nodes");
    if (nodes == nullptr) return std::move(result_);
    find_named_nodes();
    for (std::size_t i = 0; i < model_.nodes.size(); ++i) {
      const int node = static_cast<int>(i);
      if (is_cage_node(model_.nodes[i])) {
        if (const int source = mesh_ancestor(node); source >= 0) read_cage(node, source);
      } else if (is_slide_node(model_.nodes[i])) {
        read_slide(node);
      }
    }
    name_apart();
    detach_nodes();
    detach_cage_geometry(result_.base, result_.content);
    detach_extensions_used();
    return std::move(result_);
  }

 private:
  [[noreturn]] void fail(const std::string& reason) const { throw FileError(path_, {}, reason); }
  void note(const std::string& sentence) { result_.notes.push_back(path_.string() + ": " + sentence); }
  const GltfJson& node_json(int node) const {
    return (*find_key(result_.base.json, "nodes"))[static_cast<std::size_t>(node)];
  }
  int parent_of(int node) const { return parents_[static_cast<std::size_t>(node)]; }
  Eigen::Affine3d local(int node) const { return gltf_local_transform(path_, model_, node); }

  bool shows_model(int node) const {
    const tinygltf::Node& it = model_.nodes[static_cast<std::size_t>(node)];
    return it.mesh >= 0 && !is_cage_node(it);
  }
  int mesh_ancestor(int node) const {
    for (int up = parent_of(node); up >= 0; up = parent_of(up)) {
      if (shows_model(up)) return up;
    }
    return -1;
  }
  Eigen::Affine3d to_ancestor(int node, int ancestor) const {
    Eigen::Affine3d transform = Eigen::Affine3d::Identity();
    for (int up = node; up != ancestor; up = parent_of(up)) transform = local(up) * transform;
    return transform;
  }

  // ---- slides

  void read_slide(int node) {
    const std::string place = "node " + std::to_string(node) + ": ";
    const OwnSlideExtension own = read_slide_extension(path_, place, node_json(node));
    const std::string& given = model_.nodes[static_cast<std::size_t>(node)].name;
    SceneSlide slide;
    slide.id = own.id;
    slide.name = given;
    auto as_read = std::make_shared<SlideAsRead>();
    as_read->node = node_json(node);
    place_slide(node, slide, *as_read);
    as_read->is_pinned = is_used_otherwise(node);
    const Eigen::Affine3d to_mesh = as_read->parent_to_mesh * local(node);
    slide.ellipse = as_read->ellipse = transformed_circle(to_mesh);
    if (own.fitted && agrees(local(node), *own.fitted)) slide.stroke = own.stroke;
    slide.as_read = std::move(as_read);
    result_.base.keeps.insert(own.keeps.begin(), own.keeps.end());
    result_.content.slides.push_back(std::move(slide));
    slide_nodes_.push_back(node);
  }

  void place_slide(int node, SceneSlide& slide, SlideAsRead& as_read) const {
    slide.mesh_node = mesh_ancestor(node);
    as_read.parent = parent_of(node);
    if (slide.mesh_node >= 0) {
      as_read.parent_to_mesh = to_ancestor(as_read.parent, slide.mesh_node);
      return;
    }
    std::vector<int> candidates;
    for (std::size_t i = 0; i < model_.nodes.size(); ++i) {
      if (shows_model(static_cast<int>(i))) candidates.push_back(static_cast<int>(i));
    }
    if (candidates.size() != 1) {
      fail("slide " + in_quotes(slide.name) + " (node " + std::to_string(node) +
           ") is under no node with a mesh: move it under the node whose mesh it cuts");
    }
    slide.mesh_node = candidates.front();
    const Eigen::Affine3d to_world = to_ancestor(slide.mesh_node, -1);
    if (!(std::abs(to_world.linear().determinant()) > 0)) {
      fail("slide " + in_quotes(slide.name) + " is under no node with a mesh, and node " +
           std::to_string(slide.mesh_node) + " has a transform without an inverse: move the slide under that node");
    }
    as_read.parent_to_mesh = to_world.inverse() * to_ancestor(as_read.parent, -1);
  }

  // What others have put on, under or behind a slide's node.
  bool is_used_otherwise(int node) const {
    const tinygltf::Node& it = model_.nodes[static_cast<std::size_t>(node)];
    return it.mesh >= 0 || it.skin >= 0 || it.camera >= 0 || !it.children.empty() || named_elsewhere_.count(node) > 0;
  }

  // The nodes that skins and animations name.
  void find_named_nodes() {
    const auto add = [&](const GltfJson* value) {
      if (value && value->is_number_integer()) named_elsewhere_.insert(value->get<int>());
    };
    const auto each = [](const GltfJson* items, const auto& visit) {
      if (items == nullptr || !items->is_array()) return;
      for (const GltfJson& item : *items) visit(item);
    };
    each(find_key(result_.base.json, "skins"), [&](const GltfJson& skin) {
      add(find_key(skin, "skeleton"));
      each(find_key(skin, "joints"), [&](const GltfJson& joint) { add(&joint); });
    });
    each(find_key(result_.base.json, "animations"), [&](const GltfJson& animation) {
      each(find_key(animation, "channels"), [&](const GltfJson& channel) {
        if (const GltfJson* target = find_key(channel, "target")) add(find_key(*target, "node"));
      });
    });
  }

  // Ids and names as the scene needs them: the first node that has one keeps it.
  void name_apart() {
    std::int64_t next = 1;
    std::set<std::int64_t> ids;
    for (const SceneSlide& slide : result_.content.slides) next = std::max(next, slide.id + 1);
    for (const SceneCage& cage : result_.content.cages) {
      for (const std::int64_t id : cage.slides) next = std::max(next, id + 1);
    }
    std::set<std::pair<int, std::string>> names, given_names;
    for (const SceneSlide& slide : result_.content.slides) given_names.insert({slide.mesh_node, slide.name});
    for (SceneSlide& slide : result_.content.slides) {
      if (slide.id == 0 || !ids.insert(slide.id).second) {
        if (slide.id != 0)
          note("two slides have the id " + std::to_string(slide.id) + "; " + in_quotes(slide.name) + " gets " +
               std::to_string(next));
        slide.id = next++;
        ids.insert(slide.id);
      }
      if (slide.name.empty()) slide.name = "slide " + std::to_string(slide.id);
      const std::string given = slide.name;
      if (names.insert({slide.mesh_node, given}).second) continue;
      for (int copy = 2; given_names.count({slide.mesh_node, slide.name}) > 0; ++copy) {
        slide.name = given + "." + std::to_string(copy);
      }
      given_names.insert({slide.mesh_node, slide.name});
      note("two slides are called " + in_quotes(given) + "; the second is now " + in_quotes(slide.name));
    }
  }

  // ---- cages

  void read_cage(int node, int source) {
    const auto same = [&](const SceneCage& cage) { return cage.mesh_node == source; };
    if (std::any_of(result_.content.cages.begin(), result_.content.cages.end(), same)) {
      note("node " + std::to_string(source) + " has two cages; node " + std::to_string(node) + " stays as it is");
      return;
    }
    const tinygltf::Node& it = model_.nodes[static_cast<std::size_t>(node)];
    SceneCage cage =
        read_cage_extension(path_, "node " + std::to_string(node) + ": ", node_json(node), result_.base.keeps);
    cage.name = it.name;
    cage.mesh_node = source;
    cage.mesh = mesh_in(node, it.mesh, source);
    if (cage.sections.size() != cage.mesh.vertex_count()) cage.sections.clear();
    auto as_read = std::make_shared<CageAsRead>();
    as_read->node = node_json(node);
    as_read->parent = parent_of(node);
    as_read->mesh = it.mesh;
    cage.as_read = std::move(as_read);
    result_.content.cages.push_back(std::move(cage));
    cage_nodes_.push_back(node);
  }

  TriangleMesh mesh_in(int node, int mesh, int source) const {
    if (static_cast<std::size_t>(mesh) >= model_.meshes.size()) {
      fail("node " + std::to_string(node) + " shows mesh " + std::to_string(mesh) + ", which is not there");
    }
    TriangleMesh result = read_gltf_mesh(path_, model_, mesh).mesh;
    const Eigen::Affine3d to_source = to_ancestor(node, source);
    for (std::size_t i = 0; i < result.vertex_count(); ++i) {
      Eigen::Map<Eigen::Vector3d> p(&result.points[3 * i]);
      p = to_source * p;
    }
    return result;
  }

  // ---- leaving the others

  void detach_nodes() {
    std::set<int> ours(cage_nodes_.begin(), cage_nodes_.end());
    for (std::size_t k = 0; k < slide_nodes_.size(); ++k) {
      if (!result_.content.slides[k].as_read->is_pinned) ours.insert(slide_nodes_[k]);
    }
    GltfJson& json = result_.base.json;
    GltfJson& nodes = *find_key(json, "nodes");
    const bool at_the_end = ours.empty() || static_cast<std::size_t>(*ours.begin()) + ours.size() == nodes.size();
    const auto keep_home = [&](auto& owner, int node) {
      auto copy = *owner.as_read;
      if (!at_the_end || ours.count(node) == 0) copy.home = node;
      using AsRead = std::remove_const_t<typename std::remove_reference_t<decltype(owner.as_read)>::element_type>;
      owner.as_read = std::make_shared<AsRead>(std::move(copy));
    };
    for (std::size_t k = 0; k < slide_nodes_.size(); ++k) {
      keep_home(result_.content.slides[k], slide_nodes_[k]);
      if (result_.content.slides[k].as_read->is_pinned) {
        remove_own_extensions(nodes[static_cast<std::size_t>(slide_nodes_[k])]);
      }
    }
    for (std::size_t k = 0; k < cage_nodes_.size(); ++k) keep_home(result_.content.cages[k], cage_nodes_[k]);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      remove_items(nodes[i], "children", "/nodes/" + std::to_string(i) + "/children", ours);
    }
    if (GltfJson* scenes = find_key(json, "scenes"); scenes && scenes->is_array()) {
      for (std::size_t i = 0; i < scenes->size(); ++i) {
        remove_items((*scenes)[i], "nodes", "/scenes/" + std::to_string(i) + "/nodes", ours);
      }
    }
    for (const int node : ours) nodes[static_cast<std::size_t>(node)] = GltfJson::object();
    if (at_the_end) {
      nodes.erase(nodes.end() - static_cast<std::ptrdiff_t>(ours.size()), nodes.end());
    } else {
      result_.base.holes = std::move(ours);
    }
  }

  // Takes what is ours out of an array of node numbers; an array that only we have filled goes too.
  void remove_items(GltfJson& object, const char* key, const std::string& pointer, const std::set<int>& ours) {
    GltfJson* array = find_key(object, key);
    if (array == nullptr || !array->is_array()) return;
    GltfJson kept = GltfJson::array();
    for (GltfJson& item : *array) {
      if (!item.is_number_integer() || ours.count(item.get<int>()) == 0) kept.push_back(std::move(item));
    }
    const bool had_ours = kept.size() != array->size();
    *array = std::move(kept);
    if (had_ours && array->empty() && result_.base.keeps.count(pointer) == 0) object.erase(key);
  }

  void detach_extensions_used() {
    GltfJson& json = result_.base.json;
    GltfJson* used = find_key(json, "extensionsUsed");
    if (used == nullptr || !used->is_array()) return;
    GltfJson kept = GltfJson::array();
    for (GltfJson& name : *used) {
      if (name != slide_extension && name != cage_extension) kept.push_back(std::move(name));
    }
    const bool had_ours = kept.size() != used->size();
    *used = std::move(kept);
    if (had_ours && used->empty() && result_.base.keeps.count("/extensionsUsed") == 0) json.erase("extensionsUsed");
  }

  const std::filesystem::path& path_;
  const tinygltf::Model& model_;
  std::vector<int> parents_;
  std::set<int> named_elsewhere_;              // nodes that skins and animations name
  std::vector<int> slide_nodes_, cage_nodes_;  // of the content's slides and cages, in order
  TakenApart result_;
};

}  // namespace

TakenApart take_apart(const std::filesystem::path& path, GltfJson json, const tinygltf::Model& model) {
  return TakingApart(path, std::move(json), model).run();
}

}  // namespace cagewright::host
