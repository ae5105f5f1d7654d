// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_FILE_GLTF_NODES_H
#define CAGEWRIGHT_HOST_FILE_GLTF_NODES_H

#include <Eigen/Geometry>
#include <filesystem>
#include <vector>

namespace tinygltf {
class Model;
}

namespace cagewright::host {

// Of every node its parent, or -1. Throws FileError where a child is not there, a node has two parents, nodes are their
// own ancestors, or a scene has a root that is a child or there twice. O(nodes log nodes).
std::vector<int> gltf_parents(const std::filesystem::path& path, const tinygltf::Model& model);

// Throws FileError, which names the node, where translation, rotation, scale or matrix are not finite numbers of the
// right count.
// Of a node's "translation", "rotation" (x, y, z, w; of any length) and "scale", each of which may be empty.
Eigen::Affine3d gltf_transform(const std::vector<double>& translation, const std::vector<double>& rotation,
                               const std::vector<double>& scale);

Eigen::Affine3d gltf_local_transform(const std::filesystem::path& path, const tinygltf::Model& model, int node);

// The nodes of the default scene (of all roots where there is no scene) with their transforms to the scene, parents
// before children, children in their order. Throws FileError as above.
struct PlacedNode {
  int node = -1;
  Eigen::Affine3d to_scene = Eigen::Affine3d::Identity();
};
std::vector<PlacedNode> gltf_scene_nodes(const std::filesystem::path& path, const tinygltf::Model& model);

}  // namespace cagewright::host

#endif
