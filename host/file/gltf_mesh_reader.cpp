// SPDX-License-Identifier: BSD-3-Clause
#include <tiny_gltf.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "host/file/file_error.h"
#include "host/file/gltf_accessor.h"
#include "host/file/gltf_loader.h"
#include "host/file/mesh_reader.h"

namespace cagewright::host {
namespace {

// A node of the scene that shows a mesh.
struct MeshNode {
  int node = -1;  // -1: a mesh that no node shows, in a file without nodes
  int mesh = -1;
  Eigen::Affine3d to_scene = Eigen::Affine3d::Identity();
};

// The triangles of one primitive as rows of its positions.
std::vector<std::uint32_t> assemble(const std::vector<std::uint32_t>& indices, int mode) {
  if (mode == TINYGLTF_MODE_TRIANGLES) return indices;
  std::vector<std::uint32_t> triangles;
  for (std::size_t i = 0; i + 2 < indices.size(); ++i) {
    const bool is_fan = mode == TINYGLTF_MODE_TRIANGLE_FAN;
    const std::uint32_t a = is_fan ? indices[i + 1] : indices[i];
    const std::uint32_t b = is_fan ? indices[i + 2] : indices[i + 1 + i % 2];
    const std::uint32_t c = is_fan ? indices[0] : indices[i + 2 - i % 2];
    // Strips turn corners by triangles without area; they are no faces.
    if (a != b && b != c && c != a) triangles.insert(triangles.end(), {a, b, c});
  }
  return triangles;
}

bool is_triangle_mode(int mode) {
  return mode == TINYGLTF_MODE_TRIANGLES || mode == TINYGLTF_MODE_TRIANGLE_STRIP || mode == TINYGLTF_MODE_TRIANGLE_FAN;
}

class GltfMeshReader {
 public:
  explicit GltfMeshReader(const std::filesystem::path& path) : path_(path) {}

  MeshFile read(std::string_view bytes) {
    load_gltf(path_, bytes, model_);
    std::vector<std::pair<MeshNode, TriangleMesh>> shown;
    for (const MeshNode& node : mesh_nodes()) {
      TriangleMesh mesh = read_mesh_of(node);
      if (!mesh.triangles.empty()) shown.emplace_back(node, std::move(mesh));
    }
    if (shown.empty()) throw FileError(path_, {}, "holds no triangles; a closed surface is needed");
    if (shown.size() == 1) {
      result_.mesh = std::move(shown.front().second);
    } else {
      note(std::to_string(shown.size()) + " mesh nodes were merged, in the scene's space");
      for (auto& [node, mesh] : shown) append(mesh, node.to_scene);
    }
    return std::move(result_);
  }

 private:
  [[noreturn]] void fail(const std::string& reason) const { throw FileError(path_, {}, reason); }
  void note(const std::string& sentence) { result_.notes.push_back(path_.string() + ": " + sentence); }

  std::vector<int> root_nodes() const {
    if (!model_.scenes.empty()) {
      const int scene = model_.defaultScene < 0 ? 0 : model_.defaultScene;
      if (static_cast<std::size_t>(scene) >= model_.scenes.size()) {
        fail("its default scene " + std::to_string(scene) + " is not there");
      }
      return model_.scenes[static_cast<std::size_t>(scene)].nodes;
    }
    std::vector<bool> is_child(model_.nodes.size(), false);
    for (const tinygltf::Node& node : model_.nodes) {
      for (const int child : node.children) is_child[node_index(child)] = true;
    }
    std::vector<int> roots;
    for (std::size_t i = 0; i < is_child.size(); ++i) {
      if (!is_child[i]) roots.push_back(static_cast<int>(i));
    }
    if (roots.empty() && !model_.nodes.empty()) fail("its nodes form a circle");
    return roots;
  }

  std::size_t node_index(int node) const {
    if (node < 0 || static_cast<std::size_t>(node) >= model_.nodes.size()) {
      fail("names node " + std::to_string(node) + ", which is not there");
    }
    return static_cast<std::size_t>(node);
  }

  // In depth-first order, children in theirs; without recursion, as a file may nest nodes as deep as it likes.
  std::vector<MeshNode> mesh_nodes() const {
    std::vector<MeshNode> found;
    std::vector<bool> seen(model_.nodes.size(), false);
    std::vector<std::pair<int, Eigen::Affine3d>> open;
    const auto open_all = [&open](const std::vector<int>& nodes, const Eigen::Affine3d& parent) {
      for (auto node = nodes.rbegin(); node != nodes.rend(); ++node) open.emplace_back(*node, parent);
    };
    open_all(root_nodes(), Eigen::Affine3d::Identity());
    while (!open.empty()) {
      const auto [index, parent] = open.back();
      open.pop_back();
      const std::size_t row = node_index(index);
      if (seen[row]) fail("its nodes form no tree: node " + std::to_string(index) + " is reached twice");
      seen[row] = true;
      const tinygltf::Node& node = model_.nodes[row];
      const Eigen::Affine3d to_scene = parent * local_transform(node, index);
      // glTF 2.0, 3.7.3.3: a skin places its mesh, whatever the node's transform.
      if (node.mesh >= 0) found.push_back({index, node.mesh, node.skin >= 0 ? Eigen::Affine3d::Identity() : to_scene});
      open_all(node.children, to_scene);
    }
    if (model_.nodes.empty()) {
      for (std::size_t mesh = 0; mesh < model_.meshes.size(); ++mesh) found.push_back({-1, static_cast<int>(mesh)});
    }
    return found;
  }

  Eigen::Affine3d local_transform(const tinygltf::Node& node, int index) const {
    const auto check = [&](const std::vector<double>& values, std::size_t size, const char* name) {
      if (values.empty()) return false;
      bool is_good = values.size() == size;
      for (const double value : values) is_good = is_good && std::isfinite(value);
      if (!is_good) {
        fail("node " + std::to_string(index) + ": its " + name + " should be " + std::to_string(size) +
             " finite numbers");
      }
      return true;
    };
    Eigen::Affine3d transform = Eigen::Affine3d::Identity();
    if (check(node.matrix, 16, "matrix")) {
      transform.affine() = Eigen::Map<const Eigen::Matrix4d>(node.matrix.data()).topRows<3>();
      return transform;
    }
    if (check(node.translation, 3, "translation")) transform.translate(Eigen::Vector3d::Map(node.translation.data()));
    if (check(node.rotation, 4, "rotation")) {
      transform.rotate(Eigen::Quaterniond(Eigen::Vector4d::Map(node.rotation.data())).normalized());
    }
    if (check(node.scale, 3, "scale")) transform.scale(Eigen::Vector3d::Map(node.scale.data()));
    return transform;
  }

  std::string mesh_name(int mesh) const {
    const std::string& name = model_.meshes[static_cast<std::size_t>(mesh)].name;
    return "mesh " + std::to_string(mesh) + (name.empty() ? "" : " (" + in_quotes(name) + ")");
  }

  TriangleMesh read_mesh_of(const MeshNode& node) {
    if (static_cast<std::size_t>(node.mesh) >= model_.meshes.size()) {
      fail("node " + std::to_string(node.node) + " shows mesh " + std::to_string(node.mesh) + ", which is not there");
    }
    TriangleMesh mesh;
    std::map<int, std::uint32_t> first_row;  // of an accessor that several primitives share
    std::size_t skipped = 0;
    const auto& primitives = model_.meshes[static_cast<std::size_t>(node.mesh)].primitives;
    for (std::size_t i = 0; i < primitives.size(); ++i) {
      const auto position = primitives[i].attributes.find("POSITION");
      if (!is_triangle_mode(primitives[i].mode) || position == primitives[i].attributes.end()) {
        ++skipped;
        continue;
      }
      const std::string name = mesh_name(node.mesh) + ", primitive " + std::to_string(i) + ": ";
      try {
        append_primitive(primitives[i], position->second, first_row, mesh);
      } catch (const std::runtime_error& error) {
        fail(name + error.what());
      }
    }
    if (skipped > 0) {
      note(mesh_name(node.mesh) + ": " + counted(skipped, "primitive") + " without triangles not used");
    }
    return mesh;
  }

  void append_primitive(const tinygltf::Primitive& primitive, int position, std::map<int, std::uint32_t>& first_row,
                        TriangleMesh& mesh) const {
    check_compression(primitive, position);
    const auto [entry, is_new] = first_row.try_emplace(position, static_cast<std::uint32_t>(mesh.vertex_count()));
    if (is_new) append_positions(position, mesh);
    const std::size_t vertices = model_.accessors[static_cast<std::size_t>(position)].count;
    std::vector<std::uint32_t> indices;
    if (primitive.indices >= 0) {
      indices = read_indices(model_, primitive.indices);
    } else {
      for (std::size_t i = 0; i < vertices; ++i) indices.push_back(static_cast<std::uint32_t>(i));
    }
    if (primitive.mode == TINYGLTF_MODE_TRIANGLES && indices.size() % 3 != 0) {
      throw std::runtime_error("its triangles have " + counted(indices.size(), "corner") + ", not a multiple of 3");
    }
    for (std::size_t i = 0; i < indices.size(); ++i) {
      if (indices[i] < vertices) continue;
      throw std::runtime_error("index " + std::to_string(i) + " names vertex " + std::to_string(indices[i]) +
                               ", but there are only " + counted(vertices, "vertex") + " (both count from 0)");
    }
    for (const std::uint32_t vertex : assemble(indices, primitive.mode)) {
      mesh.triangles.push_back(entry->second + vertex);
    }
  }

  void check_compression(const tinygltf::Primitive& primitive, int position) const {
    const bool is_known = position >= 0 && static_cast<std::size_t>(position) < model_.accessors.size();
    if (is_known && model_.accessors[static_cast<std::size_t>(position)].bufferView < 0 &&
        primitive.extensions.count("KHR_draco_mesh_compression") > 0) {
      throw std::runtime_error("is compressed with Draco, which cannot be read; export it without compression");
    }
  }

  void append_positions(int accessor, TriangleMesh& mesh) const {
    const std::vector<double> positions = read_positions(model_, accessor);
    for (std::size_t i = 0; i < positions.size(); ++i) {
      if (!std::isfinite(positions[i])) {
        throw std::runtime_error("the position of vertex " + std::to_string(i / 3) + " is not finite");
      }
    }
    mesh.points.insert(mesh.points.end(), positions.begin(), positions.end());
    if (mesh.vertex_count() > std::numeric_limits<std::uint32_t>::max())
      throw std::runtime_error("has too many vertices");
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
  tinygltf::Model model_;
  MeshFile result_;
};

}  // namespace

MeshFile read_gltf(const std::filesystem::path& path, std::string_view bytes) {
  return GltfMeshReader(path).read(bytes);
}

}  // namespace cagewright::host
