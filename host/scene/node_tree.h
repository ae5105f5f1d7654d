// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_SCENE_NODE_TREE_H
#define CAGEWRIGHT_HOST_SCENE_NODE_TREE_H

#include <Eigen/Geometry>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "host/file/gltf_json.h"

namespace tinygltf {
class Model;
}

namespace cagewright::host {

// Where the nodes of a scene are, seen from the meshes that slides cut and cages are round. Borrows what it is made of.
class NodeTree {
 public:
  // `json` and `model` are the same file. Throws FileError: nodes that form no tree, transforms that are none. O(n).
  NodeTree(const std::filesystem::path& path, const GltfJson& json, const tinygltf::Model& model);

  int size() const { return static_cast<int>(places_.size()); }
  int parent(int node) const { return at(node).parent; }
  // Whether skins or animations name it.
  bool is_named(int node) const { return at(node).is_named; }
  // The nearest ancestor that shows a mesh which is no cage, or -1.
  int mesh_node(int node) const { return at(node).mesh_node; }
  // The nearest ancestor below the mesh node that is a slide, or -1.
  int carrier(int node) const { return at(node).carrier; }
  // To the mesh node's space; to the scene's where there is none.
  const Eigen::Affine3d& to_mesh(int node) const { return at(node).to_mesh; }

  // For a node that has lost it: the mesh node of that name, where one alone has it; else the one whose mesh has that
  // name, as Blender calls nodes of skinned meshes; else the only one.
  std::optional<int> mesh_node_for(const std::string& name, const std::string& mesh_name) const;
  // From the mesh of a node to the scene: the bind pose of a skinned one, as glTF does not look at its node. Throws
  // FileError where the skin's matrices cannot be read.
  Eigen::Affine3d shown(int mesh_node) const;
  // Its inverse. Empty where there is none. Throws as above.
  std::optional<Eigen::Affine3d> from_scene(int mesh_node) const;
  // From the mesh, as the scene shows it, to the mesh node: the identity but for skins whose bind pose is elsewhere.
  // Empty and throws as above.
  std::optional<Eigen::Affine3d> pose(int mesh_node) const;
  const Eigen::Affine3d& local(int node) const { return at(node).local; }
  // For nodes below `node` (-1: at the root) that have lost their mesh node: from their space to the scene. Where an
  // ancestor has the name of that mesh node it is in its place, and `pose` is what the mesh node's was.
  Eigen::Affine3d to_scene_below(int node, const std::string& name, const std::optional<Eigen::Affine3d>& pose) const;

 private:
  struct Place {
    int parent = -1, mesh_node = -1, carrier = -1;
    Eigen::Affine3d local = Eigen::Affine3d::Identity(), to_mesh = local, to_scene = local;
    bool is_named = false;
  };
  const Place& at(int node) const { return places_[static_cast<std::size_t>(node)]; }
  void place(int node, const Eigen::Affine3d& local);
  void find_named(const GltfJson& json);
  void find_skins(const GltfJson& json);

  Eigen::Affine3d first_matrix(int accessor) const;

  struct Skin {
    int first_joint = -1, inverse_bind_matrices = -1;
  };
  const std::filesystem::path& path_;
  const tinygltf::Model& model_;
  std::vector<Place> places_;
  std::vector<int> mesh_nodes_;
  std::vector<Skin> skins_;
};

}  // namespace cagewright::host

#endif
