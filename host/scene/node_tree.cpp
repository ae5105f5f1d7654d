// SPDX-License-Identifier: BSD-3-Clause
#include "host/scene/node_tree.h"

#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "host/file/file_error.h"
#include "host/file/gltf_accessor.h"
#include "host/file/gltf_nodes.h"
#include "host/file/gltf_own_nodes.h"

namespace cagewright::host {
namespace {

// Parents before children; without recursion, as a file may nest nodes as deep as it likes.
std::vector<int> from_the_roots(const std::vector<int>& parents, const tinygltf::Model& model) {
  std::vector<int> order;
  for (std::size_t i = 0; i < parents.size(); ++i) {
    if (parents[i] < 0) order.push_back(static_cast<int>(i));
  }
  for (std::size_t k = 0; k < order.size(); ++k) {
    const auto& children = model.nodes[static_cast<std::size_t>(order[k])].children;
    order.insert(order.end(), children.begin(), children.end());
  }
  return order;
}

template <typename Visit>
void each_item(const GltfJson* items, const Visit& visit) {
  if (items == nullptr || !items->is_array()) return;
  for (const GltfJson& item : *items) visit(item);
}

std::optional<Eigen::Affine3d> inverse_of(const Eigen::Affine3d& transform) {
  const Eigen::Affine3d inverse = transform.inverse();
  const bool has_inverse = std::abs(transform.linear().determinant()) > 0 && inverse.matrix().allFinite();
  return has_inverse ? std::optional(inverse) : std::nullopt;
}

}  // namespace

NodeTree::NodeTree(const std::filesystem::path& path, const GltfJson& json, const tinygltf::Model& model)
    : path_(path), model_(model), places_(model.nodes.size()) {
  const std::vector<int> parents = gltf_parents(path, model);
  for (std::size_t i = 0; i < parents.size(); ++i) places_[i].parent = parents[i];
  for (const int node : from_the_roots(parents, model)) place(node, gltf_local_transform(path, model, node));
  for (int node = 0; node < size(); ++node) {
    if (shows_model(model.nodes[static_cast<std::size_t>(node)])) mesh_nodes_.push_back(node);
  }
  find_named(json);
  find_skins(json);
}

void NodeTree::place(int node, const Eigen::Affine3d& local) {
  Place& here = places_[static_cast<std::size_t>(node)];
  here.local = here.to_mesh = here.to_scene = local;
  if (here.parent < 0) return;
  const Place& above = at(here.parent);
  const tinygltf::Node& parent = model_.nodes[static_cast<std::size_t>(here.parent)];
  here.to_scene = above.to_scene * local;
  if (shows_model(parent)) {
    here.mesh_node = here.parent;
    return;
  }
  here.mesh_node = above.mesh_node;
  here.to_mesh = above.to_mesh * local;
  here.carrier = is_slide_node(parent) ? here.parent : above.carrier;
}

void NodeTree::find_named(const GltfJson& json) {
  const auto add = [&](const GltfJson* value) {
    const int node = index_in(value).value_or(-1);
    if (node >= 0 && node < size()) places_[static_cast<std::size_t>(node)].is_named = true;
  };
  each_item(find_key(json, "skins"), [&](const GltfJson& skin) {
    add(find_key(skin, "skeleton"));
    each_item(find_key(skin, "joints"), [&](const GltfJson& joint) { add(&joint); });
  });
  each_item(find_key(json, "animations"), [&](const GltfJson& animation) {
    each_item(find_key(animation, "channels"), [&](const GltfJson& channel) {
      if (const GltfJson* target = find_key(channel, "target")) add(find_key(*target, "node"));
    });
  });
}

void NodeTree::find_skins(const GltfJson& json) {
  each_item(find_key(json, "skins"), [&](const GltfJson& skin) {
    Skin& here = skins_.emplace_back();
    const GltfJson* joints = find_key(skin, "joints");
    if (joints && joints->is_array() && !joints->empty()) here.first_joint = index_in(&(*joints)[0]).value_or(-1);
    here.inverse_bind_matrices = index_in(find_key(skin, "inverseBindMatrices")).value_or(-1);
  });
}

std::optional<int> NodeTree::mesh_node_for(const std::string& name, const std::string& mesh_name) const {
  if (mesh_nodes_.size() == 1) return mesh_nodes_.front();
  const auto only_one = [this](const std::string& wanted, const auto& name_of) -> std::optional<int> {
    if (wanted.empty()) return {};
    const auto is_it = [&](int node) { return name_of(model_.nodes[static_cast<std::size_t>(node)]) == wanted; };
    const auto found = std::find_if(mesh_nodes_.begin(), mesh_nodes_.end(), is_it);
    if (found == mesh_nodes_.end() || std::any_of(found + 1, mesh_nodes_.end(), is_it)) return {};
    return *found;
  };
  if (const auto found = only_one(name, [](const tinygltf::Node& node) { return node.name; })) return found;
  return only_one(mesh_name, [this](const tinygltf::Node& node) {
    const auto mesh = static_cast<std::size_t>(node.mesh);
    return mesh < model_.meshes.size() ? model_.meshes[mesh].name : "";
  });
}

Eigen::Affine3d NodeTree::first_matrix(int accessor) const {
  try {
    const std::vector<double> matrices = read_first_matrix(model_, accessor);
    if (matrices.size() < 16) return Eigen::Affine3d::Identity();
    return Eigen::Affine3d(Eigen::Map<const Eigen::Matrix4d>(matrices.data()));
  } catch (const std::runtime_error& error) {
    throw FileError(path_, {}, error.what());
  }
}

Eigen::Affine3d NodeTree::shown(int mesh_node) const {
  Eigen::Affine3d to_scene = at(mesh_node).to_scene;
  const int skin = model_.nodes[static_cast<std::size_t>(mesh_node)].skin;
  if (skin >= 0 && static_cast<std::size_t>(skin) < skins_.size()) {
    const Skin& it = skins_[static_cast<std::size_t>(skin)];
    to_scene = it.first_joint < 0 ? Eigen::Affine3d::Identity() : at(it.first_joint).to_scene;
    if (it.inverse_bind_matrices >= 0) to_scene = to_scene * first_matrix(it.inverse_bind_matrices);
  }
  return to_scene;
}

std::optional<Eigen::Affine3d> NodeTree::from_scene(int mesh_node) const { return inverse_of(shown(mesh_node)); }

std::optional<Eigen::Affine3d> NodeTree::pose(int mesh_node) const {
  if (model_.nodes[static_cast<std::size_t>(mesh_node)].skin < 0) return Eigen::Affine3d::Identity();
  const auto inverse = inverse_of(at(mesh_node).to_scene);
  return inverse ? std::optional(*inverse * shown(mesh_node)) : std::nullopt;
}

Eigen::Affine3d NodeTree::to_scene_below(int node, const std::string& name,
                                         const std::optional<Eigen::Affine3d>& pose) const {
  Eigen::Affine3d up = Eigen::Affine3d::Identity();
  for (int here = node; here >= 0; here = parent(here)) {
    const bool is_in_its_place = !name.empty() && model_.nodes[static_cast<std::size_t>(here)].name == name;
    if (is_in_its_place) return at(here).to_scene * pose.value_or(Eigen::Affine3d::Identity()) * up;
    up = at(here).local * up;
  }
  return up;
}

}  // namespace cagewright::host
