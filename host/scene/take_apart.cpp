// SPDX-License-Identifier: BSD-3-Clause
#include <tiny_gltf.h>

#include <algorithm>
#include <limits>

#include "host/file/file_error.h"
#include "host/file/gltf_geometry.h"
#include "host/file/gltf_own_nodes.h"
#include "host/scene/cage_geometry.h"
#include "host/scene/detach_nodes.h"
#include "host/scene/mesh_fingerprint.h"
#include "host/scene/name_apart.h"
#include "host/scene/node_tree.h"
#include "host/scene/own_extension.h"
#include "host/scene/scene_parts.h"
#include "host/scene/slide_transform.h"

namespace cagewright::host {
namespace {

// Whether a slide's transform is still the one that its stroke was fitted to, but for the rounding of a tool that keeps
// floats.
bool agrees(const Eigen::Affine3d& transform, const TranslationRotationScale& fitted) {
  constexpr double rounding = 1e-6;
  const Eigen::Affine3d then = compose(fitted);
  const double size = then.linear().norm(), place = std::numeric_limits<float>::epsilon() * then.translation().norm();
  return (transform.linear() - then.linear()).norm() <= rounding * size &&
         (transform.translation() - then.translation()).norm() <= rounding * size + place;
}

class TakingApart {
 public:
  TakingApart(const std::filesystem::path& path, GltfJson json, const tinygltf::Model& model,
              SceneDocument::Unreadable unreadable)
      : path_(path), model_(model), unreadable_(unreadable), tree_(path, json, model) {
    result_.base.json = std::move(json);
  }

  TakenApart run() {
    if (find_key(result_.base.json, "nodes") == nullptr) return std::move(result_);
    find_poses();
    for (int node = 0; node < tree_.size(); ++node) {
      if (is_slide(node)) read([&] { read_slide(node); }, node);
      if (is_empty_cage_node(typed(node))) {
        note(place_of(node) + " has no mesh, and stays as it is: delete it, or strip the scene");
        add_stray(node);
      }
    }
    // Of several cages of one mesh the one that lies where we have put it counts, so that it stays the same one.
    for (const Place place : {Place::in_mesh_space, Place::moved, Place::orphaned}) {
      for (int node = 0; node < tree_.size(); ++node) {
        if (is_cage(node) && cage_place(node) == place) read([&] { read_cage(node); }, node);
      }
    }
    find_shells();
    for (std::string& sentence : name_apart(result_.content)) note(sentence);
    detach_nodes(result_.base, result_.content, nodes_);
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
  const tinygltf::Node& typed(int node) const { return model_.nodes[static_cast<std::size_t>(node)]; }
  bool is_cage(int node) const { return is_cage_node(typed(node)); }
  bool is_slide(int node) const {
    return is_slide_node(typed(node)) && !is_cage(node) && !is_empty_cage_node(typed(node));
  }

  enum class Place { in_mesh_space, moved, orphaned };
  Place cage_place(int node) const {
    if (tree_.mesh_node(node) < 0) return Place::orphaned;
    return tree_.to_mesh(node).matrix() == Eigen::Matrix4d::Identity() ? Place::in_mesh_space : Place::moved;
  }

  void find_poses() {
    for (int node = 0; node < tree_.size(); ++node) {
      if (!shows_model(typed(node)) || typed(node).skin < 0) continue;
      try {
        const auto pose = tree_.pose(node);
        const bool is_known = pose && pose->matrix().allFinite();
        if (is_known && !pose->matrix().isIdentity(1e-6)) result_.base.poses.emplace(node, *pose);
      } catch (const FileError&) {
        continue;  // a skin that cannot be read: nothing of ours needs it
      }
    }
  }

  // Nodes that are pinned by nothing but nodes of ours below them.
  void find_shells() {
    const auto look = [&](const auto& owners, const std::vector<int>& places) {
      for (std::size_t k = 0; k < places.size(); ++k) {
        GltfJson rest = owners[k].as_read->node;
        const GltfJson* children = find_key(rest, "children");
        if (!owners[k].as_read->is_pinned || tree_.is_named(places[k]) || !children || !children->is_array()) continue;
        const bool only_ours = std::all_of(children->begin(), children->end(), [&](const GltfJson& child) {
          const int node = child.is_number_integer() ? child.get<int>() : -1;
          return node >= 0 && node < tree_.size() && (is_slide(node) || is_cage(node));
        });
        rest.erase("children");
        if (only_ours && !has_content_of_others(rest, is_cage(places[k])))
          result_.base.shells.emplace(places[k], tree_.parent(places[k]));
      }
    };
    look(result_.content.slides, nodes_.slides);
    look(result_.content.cages, nodes_.cages);
    look(result_.content.strays, nodes_.strays);
  }
  std::string place_of(int node) const {
    return (is_cage(node) || is_empty_cage_node(typed(node)) ? "cage " : "slide ") + in_quotes(typed(node).name) +
           " (node " + std::to_string(node) + ")";
  }
  const GltfJson& node_json(int node) const {
    return (*find_key(result_.base.json, "nodes"))[static_cast<std::size_t>(node)];
  }

  template <typename Reading>
  void read(const Reading& reading, int node) {
    try {
      reading();
    } catch (const FileError& error) {
      if (unreadable_ == SceneDocument::Unreadable::refused) throw;
      result_.notes.emplace_back(error.what());
      add_stray(node);
    }
  }

  void describe(int node, NodeAsRead& as_read) const {
    as_read.node = node_json(node);
    as_read.parent = tree_.parent(node);
    as_read.carrier = tree_.carrier(node);
    as_read.is_pinned = tree_.is_named(node) || has_content_of_others(as_read.node, is_cage(node));
  }

  void add_stray(int node) {
    auto as_read = std::make_shared<CageAsRead>();
    describe(node, *as_read);
    const bool is_of_a_cage = is_cage(node) || is_empty_cage_node(typed(node));
    if (is_of_a_cage) as_read->mesh = typed(node).mesh;
    result_.content.strays.push_back({typed(node).name, is_of_a_cage, std::move(as_read)});
    nodes_.strays.push_back(node);
  }

  void read_slide(int node) {
    const OwnSlideExtension own = read_slide_extension(path_, place_of(node) + ": ", node_json(node));
    SceneSlide slide;
    slide.id = own.id;
    slide.name = typed(node).name;
    auto as_read = std::make_shared<SlideAsRead>();
    describe(node, *as_read);
    const Eigen::Affine3d to_mesh = place_slide(node, own, slide, *as_read);
    const Eigen::Vector3d cross = to_mesh.linear().col(0).cross(to_mesh.linear().col(1));
    if (!to_mesh.matrix().allFinite() || !cross.allFinite() || !(cross.stableNorm() > 0)) {
      fail(place_of(node) +
           ": its transform makes an ellipse without area, or beyond all bounds; scale it or delete it");
    }
    slide.ellipse = as_read->ellipse = transformed_circle(to_mesh);
    if (own.fitted && agrees(to_mesh, *own.fitted)) {
      slide.stroke = own.stroke;
      as_read->fitted = own.fitted;
    }
    if (as_read->carrier >= 0) result_.base.carriers[node] = as_read->carrier;
    slide.as_read = std::move(as_read);
    result_.base.keeps.insert(own.keeps.begin(), own.keeps.end());
    result_.content.slides.push_back(std::move(slide));
    nodes_.slides.push_back(node);
  }

  // Returns its transform relative to the mesh node.
  Eigen::Affine3d place_slide(int node, const OwnSlideExtension& own, SceneSlide& slide, SlideAsRead& as_read) const {
    slide.mesh_node = tree_.mesh_node(node);
    if (as_read.parent >= 0 && as_read.parent != slide.mesh_node)
      as_read.parent_to_mesh = tree_.to_mesh(as_read.parent);
    if (slide.mesh_node >= 0) return tree_.to_mesh(node);
    const auto found = tree_.mesh_node_for(own.source.node, own.source.mesh);
    if (!found) fail(place_of(node) + " is under no node with a mesh: move it under the node whose mesh it cuts");
    slide.mesh_node = *found;
    const auto from_scene = tree_.from_scene(*found);
    if (!from_scene) {
      fail(place_of(node) + " is under no node with a mesh, and node " + std::to_string(*found) +
           " has a transform without an inverse: move the slide under that node");
    }
    as_read.parent_to_mesh = *from_scene * tree_.to_scene_below(as_read.parent, own.source.node, own.pose);
    return as_read.parent_to_mesh * tree_.local(node);
  }

  void read_cage(int node) {
    OwnCageExtension own = read_cage_extension(path_, place_of(node) + ": ", node_json(node));
    result_.base.keeps.insert(own.keeps.begin(), own.keeps.end());
    SceneCage& cage = own.cage;
    Eigen::Affine3d to_mesh = tree_.to_mesh(node);
    cage.mesh_node = tree_.mesh_node(node);
    if (cage.mesh_node < 0) {
      const auto found = tree_.mesh_node_for(own.source.node, own.source.mesh);
      const auto from_scene = found ? tree_.from_scene(*found) : std::nullopt;
      if (!from_scene) {
        note(
            place_of(node) +
            " is under no node with a mesh, and stays as it is: move it under the one it is round, or strip the scene");
        return add_stray(node);
      }
      cage.mesh_node = *found;
      to_mesh = *from_scene * tree_.to_scene_below(tree_.parent(node), own.source.node, own.pose) * tree_.local(node);
    }
    if (!meshes_with_cage_.insert(cage.mesh_node).second) {
      note("node " + std::to_string(cage.mesh_node) + " has two cages; " + place_of(node) +
           " stays as it is: delete one of them, or strip the scene");
      return add_stray(node);
    }
    cage.name = typed(node).name;
    try {
      cage.mesh = mesh_in(typed(node).mesh, to_mesh);
    } catch (const FileError&) {
      meshes_with_cage_.erase(cage.mesh_node);
      throw;
    }
    if (cage.mesh.triangles.empty()) {
      meshes_with_cage_.erase(cage.mesh_node);
      note(place_of(node) + " has no triangles, and stays as it is: delete it, or strip the scene");
      return add_stray(node);
    }
    forget_other_meshes_sections(node, cage);
    forget_other_meshes_certificate(node, cage);
    auto as_read = std::make_shared<CageAsRead>();
    describe(node, *as_read);
    as_read->mesh = typed(node).mesh;
    as_read->is_elsewhere = tree_.mesh_node(node) < 0 || to_mesh.matrix() != Eigen::Matrix4d::Identity();
    cage.as_read = std::move(as_read);
    cage.is_as_read = tree_.mesh_node(node) >= 0;
    result_.content.cages.push_back(std::move(cage));
    nodes_.cages.push_back(node);
  }

  void forget_other_meshes_sections(int node, SceneCage& cage) {
    if (cage.sections.empty() || cage.sections.size() == cage.mesh.vertex_count()) return;
    note(place_of(node) + " has " + counted(cage.mesh.vertex_count(), "vertex") + ", but sections for " +
         std::to_string(cage.sections.size()) + ": it was changed, and its sections and certificate no longer count");
    cage.sections.clear();
    cage.certificate.clear();
  }

  // What it is of is in it, where it was written with the cage.
  void forget_other_meshes_certificate(int node, SceneCage& cage) {
    if (cage.certificate.empty()) return;
    const GltfJson certificate = parse_gltf_json(path_, cage.certificate);
    const GltfJson* of = find_key(certificate, "of");
    if (of == nullptr) return;
    const auto is_of = [of](const char* key, const TriangleMesh& mesh) {
      const GltfJson* fingerprint = find_key(*of, key);
      return fingerprint && *fingerprint == mesh_fingerprint(mesh);
    };
    if (is_of("cage", cage.mesh) && is_of("model", model_mesh(cage.mesh_node))) return;
    note(place_of(node) + " or its model was changed since the cage was made: its certificate no longer counts");
    cage.certificate.clear();
  }

  TriangleMesh model_mesh(int node) const {
    try {
      return read_gltf_mesh(path_, model_, typed(node).mesh).mesh;
    } catch (const FileError&) {
      return {};
    }
  }

  TriangleMesh mesh_in(int mesh, const Eigen::Affine3d& to_mesh) const {
    TriangleMesh result = read_gltf_mesh(path_, model_, mesh).mesh;
    for (std::size_t i = 0; i < result.vertex_count(); ++i) {
      Eigen::Map<Eigen::Vector3d> p(&result.points[3 * i]);
      p = to_mesh * p;
    }
    if (to_mesh.linear().determinant() < 0) {
      for (std::size_t t = 0; t < result.triangle_count(); ++t) {
        std::swap(result.triangles[3 * t + 1], result.triangles[3 * t + 2]);
      }
    }
    return result;
  }

  const std::filesystem::path& path_;
  const tinygltf::Model& model_;
  SceneDocument::Unreadable unreadable_;
  NodeTree tree_;
  OwnNodes nodes_;
  std::set<int> meshes_with_cage_;
  TakenApart result_;
};

}  // namespace

SlideIds ids_in(const SceneContent& content) {
  SlideIds ids;
  for (const SceneSlide& slide : content.slides) ids.take(slide.id);
  for (const SceneCage& cage : content.cages) {
    for (const std::int64_t id : cage.slides) ids.take(id);
  }
  return ids;
}

TakenApart take_apart(const std::filesystem::path& path, GltfJson json, const tinygltf::Model& model,
                      SceneDocument::Unreadable unreadable) {
  return TakingApart(path, std::move(json), model, unreadable).run();
}

}  // namespace cagewright::host
