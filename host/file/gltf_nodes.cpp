// SPDX-License-Identifier: BSD-3-Clause
#include "host/file/gltf_nodes.h"

#include <tiny_gltf.h>

#include <cmath>
#include <set>
#include <string>
#include <utility>

#include "host/file/file_error.h"

namespace cagewright::host {
namespace {

class Nodes {
 public:
  Nodes(const std::filesystem::path& path, const tinygltf::Model& model) : path_(path), model_(model) {}

  [[noreturn]] void fail(const std::string& reason) const { throw FileError(path_, {}, reason + "; export it again"); }

  std::size_t index(int node) const {
    if (node < 0 || static_cast<std::size_t>(node) >= model_.nodes.size()) {
      fail("names node " + std::to_string(node) + ", which is not there");
    }
    return static_cast<std::size_t>(node);
  }

  std::vector<int> parents() const {
    std::vector<int> parents(model_.nodes.size(), -1);
    for (std::size_t i = 0; i < model_.nodes.size(); ++i) {
      for (const int child : model_.nodes[i].children) {
        int& parent = parents[index(child)];
        if (parent >= 0) fail("its nodes form no tree: node " + std::to_string(child) + " has two parents");
        parent = static_cast<int>(i);
      }
    }
    check_ancestors(parents);
    check_roots(parents);
    return parents;
  }

  std::vector<int> roots() const {
    if (!model_.scenes.empty()) {
      const int scene = model_.defaultScene < 0 ? 0 : model_.defaultScene;
      if (static_cast<std::size_t>(scene) >= model_.scenes.size()) {
        fail("its default scene " + std::to_string(scene) + " is not there");
      }
      return model_.scenes[static_cast<std::size_t>(scene)].nodes;
    }
    std::vector<bool> is_child(model_.nodes.size(), false);
    for (const tinygltf::Node& node : model_.nodes) {
      for (const int child : node.children) is_child[index(child)] = true;
    }
    std::vector<int> roots;
    for (std::size_t i = 0; i < is_child.size(); ++i) {
      if (!is_child[i]) roots.push_back(static_cast<int>(i));
    }
    if (roots.empty() && !model_.nodes.empty()) fail("its nodes form a circle");
    return roots;
  }

  Eigen::Affine3d local_transform(int node_index) const {
    const tinygltf::Node& node = model_.nodes[index(node_index)];
    const auto check = [&](const std::vector<double>& values, std::size_t size, const char* name) {
      if (values.empty()) return false;
      bool is_good = values.size() == size;
      for (const double value : values) is_good = is_good && std::isfinite(value);
      if (!is_good) {
        fail("node " + std::to_string(node_index) + ": its " + name + " should be " + std::to_string(size) +
             " finite numbers");
      }
      return true;
    };
    Eigen::Affine3d transform = Eigen::Affine3d::Identity();
    if (check(node.matrix, 16, "matrix")) {
      transform.affine() = Eigen::Map<const Eigen::Matrix4d>(node.matrix.data()).topRows<3>();
      return transform;
    }
    check(node.translation, 3, "translation");
    check(node.rotation, 4, "rotation");
    check(node.scale, 3, "scale");
    return gltf_transform(node.translation, node.rotation, node.scale);
  }

 private:
  void check_roots(const std::vector<int>& parents) const {
    for (std::size_t s = 0; s < model_.scenes.size(); ++s) {
      std::set<int> roots;
      for (const int root : model_.scenes[s].nodes) {
        const bool is_child = parents[index(root)] >= 0;
        if (!is_child && roots.insert(root).second) continue;
        fail("its nodes form no tree: node " + std::to_string(root) + " is at the root of scene " + std::to_string(s) +
             (is_child ? " and a child of node " + std::to_string(parents[index(root)]) : " twice"));
      }
    }
  }

  // Every node has one parent at most, so a walk upwards that does not end comes back to where it began.
  void check_ancestors(const std::vector<int>& parents) const {
    std::vector<int> seen_from(parents.size(), -1);
    for (std::size_t i = 0; i < parents.size(); ++i) {
      for (int node = static_cast<int>(i); node >= 0; node = parents[static_cast<std::size_t>(node)]) {
        int& seen = seen_from[static_cast<std::size_t>(node)];
        if (seen == static_cast<int>(i)) fail("its nodes form a circle: node " + std::to_string(node) + " is in it");
        if (seen >= 0) break;
        seen = static_cast<int>(i);
      }
    }
  }

  const std::filesystem::path& path_;
  const tinygltf::Model& model_;
};

}  // namespace

std::vector<int> gltf_parents(const std::filesystem::path& path, const tinygltf::Model& model) {
  return Nodes(path, model).parents();
}

Eigen::Affine3d gltf_transform(const std::vector<double>& translation, const std::vector<double>& rotation,
                               const std::vector<double>& scale) {
  Eigen::Affine3d transform = Eigen::Affine3d::Identity();
  if (!translation.empty()) transform.translate(Eigen::Vector3d::Map(translation.data()));
  if (!rotation.empty()) {
    transform.rotate(Eigen::Quaterniond(Eigen::Vector4d::Map(rotation.data())).normalized());
  }
  if (!scale.empty()) transform.scale(Eigen::Vector3d::Map(scale.data()));
  return transform;
}

Eigen::Affine3d gltf_local_transform(const std::filesystem::path& path, const tinygltf::Model& model, int node) {
  return Nodes(path, model).local_transform(node);
}

// Without recursion, as a file may nest nodes as deep as it likes.
std::vector<PlacedNode> gltf_scene_nodes(const std::filesystem::path& path, const tinygltf::Model& model) {
  const Nodes nodes(path, model);
  std::vector<PlacedNode> placed, open;
  std::vector<bool> seen(model.nodes.size(), false);
  const auto open_all = [&open](const std::vector<int>& children, const Eigen::Affine3d& parent) {
    for (auto node = children.rbegin(); node != children.rend(); ++node) open.push_back({*node, parent});
  };
  open_all(nodes.roots(), Eigen::Affine3d::Identity());
  while (!open.empty()) {
    PlacedNode here = open.back();
    open.pop_back();
    const std::size_t row = nodes.index(here.node);
    if (seen[row]) nodes.fail("its nodes form no tree: node " + std::to_string(here.node) + " is reached twice");
    seen[row] = true;
    here.to_scene = here.to_scene * nodes.local_transform(here.node);
    placed.push_back(here);
    open_all(model.nodes[row].children, here.to_scene);
  }
  return placed;
}

}  // namespace cagewright::host
