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
#include "host/scene/detach_nodes.h"
#include "host/scene/own_extension.h"
#include "host/scene/scene_parts.h"
#include "host/scene/slide_transform.h"

namespace cagewright::host {
namespace {

// Whether a slide's transform is still the one that its stroke was fitted to, but for the rounding of a tool that keeps
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
        read_cage(node);
      } else if (is_slide_node(model_.nodes[i])) {
        read_slide(node);
      }
    }
    name_apart();
    detach_nodes(result_.base, result_.content, slide_nodes_, cage_nodes_);
    detach_cage_geometry(result_.base, result_.content);
    // By age, however a tool has sorted the nodes: so a cage's vertices keep their order.
    std::stable_sort(result_.content.slides.begin(), result_.content.slides.end(),
                     [](const SceneSlide& a, const SceneSlide& b) { return a.id < b.id; });
    std::stable_sort(result_.content.cages.begin(), result_.content.cages.end(),
                     [](const SceneCage& a, const SceneCage& b) { return a.mesh_node < b.mesh_node; });
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

  std::string slide_at(int node) const {
    return "slide " + in_quotes(model_.nodes[static_cast<std::size_t>(node)].name) + " (node " + std::to_string(node) +
           ")";
  }

  void read_slide(int node) {
    const OwnSlideExtension own = read_slide_extension(path_, slide_at(node) + ": ", node_json(node));
    SceneSlide slide;
    slide.id = own.id;
    slide.name = model_.nodes[static_cast<std::size_t>(node)].name;
    auto as_read = std::make_shared<SlideAsRead>();
    as_read->node = node_json(node);
    place_slide(node, slide, *as_read);
    for (int up = as_read->parent; up >= 0 && up != slide.mesh_node; up = parent_of(up)) {
      if (is_slide_node(model_.nodes[static_cast<std::size_t>(up)])) as_read->carriers.push_back(up);
    }
    as_read->is_pinned = named_elsewhere_.count(node) > 0 || has_content_of_others(node_json(node), false);
    const Eigen::Affine3d to_mesh = as_read->parent_to_mesh * local(node);
    const Eigen::Vector3d cross = to_mesh.linear().col(0).cross(to_mesh.linear().col(1));
    if (!to_mesh.matrix().allFinite() || !cross.allFinite() || !(cross.stableNorm() > 0)) {
      fail(slide_at(node) +
           ": its transform makes an ellipse without area, or beyond all bounds; scale it or delete it");
    }
    slide.ellipse = as_read->ellipse = transformed_circle(to_mesh);
    if (own.fitted && agrees(to_mesh, *own.fitted)) {
      slide.stroke = own.stroke;
      as_read->fitted = own.fitted;
    }
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
      fail(slide_at(node) + " is under no node with a mesh: move it under the node whose mesh it cuts");
    }
    slide.mesh_node = candidates.front();
    const Eigen::Affine3d to_world = to_ancestor(slide.mesh_node, -1);
    if (!(std::abs(to_world.linear().determinant()) > 0)) {
      fail(slide_at(node) + " is under no node with a mesh, and node " + std::to_string(slide.mesh_node) +
           " has a transform without an inverse: move the slide under that node");
    }
    as_read.parent_to_mesh = to_world.inverse() * to_ancestor(as_read.parent, -1);
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
    std::set<std::int64_t> taken = ids_in(result_.content), seen;
    std::map<std::pair<int, std::int64_t>, std::int64_t> renumbered;  // by mesh node and old id
    std::set<std::pair<int, std::int64_t>> kept;
    std::set<std::pair<int, std::string>> names, given_names;
    for (const SceneSlide& slide : result_.content.slides) given_names.insert({slide.mesh_node, slide.name});
    for (SceneSlide& slide : result_.content.slides) {
      if (seen.insert(slide.id).second) {
        kept.insert({slide.mesh_node, slide.id});
      } else {
        const std::int64_t id = free_slide_id(taken);
        note("two slides have the id " + std::to_string(slide.id) + "; " + in_quotes(slide.name) + " gets " +
             std::to_string(id));
        renumbered.try_emplace({slide.mesh_node, slide.id}, id);
        taken.insert(slide.id = id);
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
    // A mesh node that was duplicated with its slides has a cage that names their old ids.
    for (SceneCage& cage : result_.content.cages) {
      for (std::int64_t& id : cage.slides) {
        const auto found = renumbered.find({cage.mesh_node, id});
        if (found != renumbered.end() && kept.count({cage.mesh_node, id}) == 0) id = found->second;
      }
    }
  }

  // ---- cages

  std::string cage_at(int node) const {
    return "cage " + in_quotes(model_.nodes[static_cast<std::size_t>(node)].name) + " (node " + std::to_string(node) +
           ")";
  }

  void read_cage(int node) {
    const int source = mesh_ancestor(node);
    SceneCage cage = read_cage_extension(path_, cage_at(node) + ": ", node_json(node), result_.base.keeps);
    const tinygltf::Node& it = model_.nodes[static_cast<std::size_t>(node)];
    if (source < 0) {
      return note(cage_at(node) +
                  " is under no node with a mesh, and stays as it is: move it under the one it is round");
    }
    const auto same = [&](const SceneCage& other) { return other.mesh_node == source; };
    if (std::any_of(result_.content.cages.begin(), result_.content.cages.end(), same)) {
      return note("node " + std::to_string(source) + " has two cages; " + cage_at(node) + " stays as it is");
    }
    cage.name = it.name;
    cage.mesh_node = source;
    cage.mesh = mesh_in(node, it.mesh, source);
    if (cage.mesh.triangles.empty()) return note(cage_at(node) + " has no triangles, and stays as it is");
    if (!cage.sections.empty() && cage.sections.size() != cage.mesh.vertex_count()) {
      note(cage_at(node) + " has " + counted(cage.mesh.vertex_count(), "vertex") + ", but sections for " +
           std::to_string(cage.sections.size()) + ": it was changed, and its sections and certificate no longer count");
      cage.sections.clear();
      cage.certificate.clear();
    }
    auto as_read = std::make_shared<CageAsRead>();
    as_read->node = node_json(node);
    as_read->parent = parent_of(node);
    as_read->mesh = it.mesh;
    as_read->is_pinned = named_elsewhere_.count(node) > 0 || has_content_of_others(node_json(node), true);
    cage.as_read = std::move(as_read);
    result_.content.cages.push_back(std::move(cage));
    cage_nodes_.push_back(node);
  }

  TriangleMesh mesh_in(int node, int mesh, int source) const {
    TriangleMesh result = read_gltf_mesh(path_, model_, mesh).mesh;
    const Eigen::Affine3d to_source = to_ancestor(node, source);
    for (std::size_t i = 0; i < result.vertex_count(); ++i) {
      Eigen::Map<Eigen::Vector3d> p(&result.points[3 * i]);
      p = to_source * p;
    }
    if (to_source.linear().determinant() < 0) {
      for (std::size_t t = 0; t < result.triangle_count(); ++t) {
        std::swap(result.triangles[3 * t + 1], result.triangles[3 * t + 2]);
      }
    }
    return result;
  }

  const std::filesystem::path& path_;
  const tinygltf::Model& model_;
  std::vector<int> parents_;
  std::set<int> named_elsewhere_;              // nodes that skins and animations name
  std::vector<int> slide_nodes_, cage_nodes_;  // of the content's slides and cages, in order
  TakenApart result_;
};

}  // namespace

std::set<std::int64_t> ids_in(const SceneContent& content) {
  std::set<std::int64_t> ids;
  for (const SceneSlide& slide : content.slides) ids.insert(slide.id);
  for (const SceneCage& cage : content.cages) ids.insert(cage.slides.begin(), cage.slides.end());
  return ids;
}

TakenApart take_apart(const std::filesystem::path& path, GltfJson json, const tinygltf::Model& model) {
  return TakingApart(path, std::move(json), model).run();
}

}  // namespace cagewright::host
