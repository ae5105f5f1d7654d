// SPDX-License-Identifier: BSD-3-Clause
#include <tiny_gltf.h>

#include <string>
#include <utility>
#include <vector>

#include "host/file/file_error.h"
#include "host/file/gltf_geometry.h"
#include "host/file/gltf_loader.h"
#include "host/file/gltf_nodes.h"
#include "host/file/gltf_own_nodes.h"
#include "host/file/mesh_reader.h"

namespace cagewright::host {
namespace {

// A node of the scene that shows a mesh.
struct MeshNode {
  int node = -1;  // -1: a mesh that no node shows, in a file without nodes
  int mesh = -1;
  Eigen::Affine3d to_scene = Eigen::Affine3d::Identity();
  bool is_placed = false;  // its transform counts even where nothing else is read
};

class GltfMeshReader {
 public:
  GltfMeshReader(const std::filesystem::path& path, MeshRole role) : path_(path), role_(role) {}

  MeshFile read(std::string_view bytes) {
    load_gltf(path_, bytes, model_);
    std::vector<std::pair<MeshNode, TriangleMesh>> shown;
    for (const MeshNode& node : mesh_nodes()) {
      TriangleMesh mesh = read_mesh_of(node);
      if (!mesh.triangles.empty()) shown.emplace_back(node, std::move(mesh));
    }
    if (shown.empty()) throw FileError(path_, {}, "holds no triangles; a closed surface is needed");
    if (shown.size() == 1 && !shown.front().first.is_placed) {
      result_.mesh = std::move(shown.front().second);
    } else {
      if (shown.size() > 1) note(std::to_string(shown.size()) + " mesh nodes were merged, in the scene's space");
      for (auto& [node, mesh] : shown) append(mesh, node.to_scene);
    }
    return std::move(result_);
  }

 private:
  [[noreturn]] void fail(const std::string& reason) const { throw FileError(path_, {}, reason); }
  void note(const std::string& sentence) { result_.notes.push_back(path_.string() + ": " + sentence); }

  std::vector<MeshNode> mesh_nodes() const {
    std::vector<MeshNode> models, cages;
    for (const PlacedNode& placed : gltf_scene_nodes(path_, model_)) {
      const tinygltf::Node& node = model_.nodes[static_cast<std::size_t>(placed.node)];
      if (node.mesh < 0) continue;
      // glTF 2.0, 3.7.3.3: a skin places its mesh, whatever the node's transform.
      const bool is_skinned = node.skin >= 0 && !is_cage_node(node);
      const Eigen::Affine3d to_scene = is_skinned ? Eigen::Affine3d::Identity() : placed.to_scene;
      (is_cage_node(node) ? cages : models).push_back({placed.node, node.mesh, to_scene});
    }
    if (model_.nodes.empty()) {
      for (std::size_t mesh = 0; mesh < model_.meshes.size(); ++mesh) models.push_back({-1, static_cast<int>(mesh)});
    }
    if (role_ == MeshRole::model || cages.empty()) return models;
    // Where the model is read in its own space, so is what is round it.
    for (MeshNode& cage : cages) {
      if (models.size() == 1) cage.to_scene = seen_from(cage, models.front().node);
      cage.is_placed = !models.empty() && cage.to_scene.matrix() != Eigen::Matrix4d::Identity();
    }
    return cages;
  }

  Eigen::Affine3d seen_from(const MeshNode& cage, int model) const {
    const std::vector<int> parents = gltf_parents(path_, model_);
    Eigen::Affine3d up = Eigen::Affine3d::Identity();
    for (int node = cage.node; node >= 0; node = parents[static_cast<std::size_t>(node)]) {
      if (node == model) return up;
      up = gltf_local_transform(path_, model_, node) * up;
    }
    Eigen::Affine3d model_to_scene = Eigen::Affine3d::Identity();
    for (int node = model; node >= 0; node = parents[static_cast<std::size_t>(node)]) {
      model_to_scene = gltf_local_transform(path_, model_, node) * model_to_scene;
    }
    return model_to_scene.inverse() * up;
  }

  TriangleMesh read_mesh_of(const MeshNode& node) {
    if (static_cast<std::size_t>(node.mesh) >= model_.meshes.size()) {
      fail("node " + std::to_string(node.node) + " shows mesh " + std::to_string(node.mesh) + ", which is not there");
    }
    MeshFile file = read_gltf_mesh(path_, model_, node.mesh);
    for (std::string& sentence : file.notes) result_.notes.push_back(std::move(sentence));
    return std::move(file.mesh);
  }

  void append(TriangleMesh& part, const Eigen::Affine3d& to_scene) {
    TriangleMesh& whole = result_.mesh;
    const auto first = static_cast<std::uint32_t>(whole.vertex_count());
    for (std::size_t i = 0; i < part.vertex_count(); ++i) {
      const Eigen::Vector3d p = to_scene * Eigen::Vector3d::Map(&part.points[3 * i]);
      if (!p.allFinite()) fail("a node's transform moves vertices to infinity");
      whole.points.insert(whole.points.end(), p.begin(), p.end());
    }
    // glTF 2.0, 3.7.4: a transform that mirrors turns the triangles' order round.
    const bool is_mirrored = to_scene.linear().determinant() < 0;
    for (std::size_t t = 0; t < part.triangle_count(); ++t) {
      std::uint32_t* corners = &part.triangles[3 * t];
      if (is_mirrored) std::swap(corners[1], corners[2]);
      for (int k = 0; k < 3; ++k) whole.triangles.push_back(first + corners[k]);
    }
  }

  const std::filesystem::path& path_;
  MeshRole role_;
  tinygltf::Model model_;
  MeshFile result_;
};

}  // namespace

MeshFile read_gltf(const std::filesystem::path& path, std::string_view bytes, MeshRole role) {
  return GltfMeshReader(path, role).read(bytes);
}

}  // namespace cagewright::host
