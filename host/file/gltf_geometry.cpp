// SPDX-License-Identifier: BSD-3-Clause
#include "host/file/gltf_geometry.h"

#include <tiny_gltf.h>

#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "host/file/file_error.h"
#include "host/file/gltf_accessor.h"

namespace cagewright::host {
namespace {

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

class GeometryReader {
 public:
  GeometryReader(const std::filesystem::path& path, const tinygltf::Model& model) : path_(path), model_(model) {}

  MeshFile read(int index) const {
    MeshFile file;
    TriangleMesh& mesh = file.mesh;
    std::map<int, std::uint32_t> first_row;  // of an accessor that several primitives share
    std::size_t skipped = 0;
    const auto& primitives = model_.meshes[static_cast<std::size_t>(index)].primitives;
    for (std::size_t i = 0; i < primitives.size(); ++i) {
      const auto position = primitives[i].attributes.find("POSITION");
      if (!is_triangle_mode(primitives[i].mode) || position == primitives[i].attributes.end()) {
        ++skipped;
        continue;
      }
      const std::string name = mesh_name(index) + ", primitive " + std::to_string(i) + ": ";
      try {
        append_primitive(primitives[i], position->second, first_row, mesh);
      } catch (const std::runtime_error& error) {
        fail(name + error.what());
      }
    }
    if (skipped > 0) {
      file.notes.push_back(path_.string() + ": " + mesh_name(index) + ": " + counted(skipped, "primitive") +
                           " without triangles not used");
    }
    return file;
  }

 private:
  [[noreturn]] void fail(const std::string& reason) const { throw FileError(path_, {}, reason); }

  std::string mesh_name(int mesh) const {
    const std::string& name = model_.meshes[static_cast<std::size_t>(mesh)].name;
    return "mesh " + std::to_string(mesh) + (name.empty() ? "" : " (" + in_quotes(name) + ")");
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
      throw std::runtime_error("its triangles have " + counted(indices.size(), "corner") +
                               ", not a multiple of 3; export it again");
    }
    for (std::size_t i = 0; i < indices.size(); ++i) {
      if (indices[i] < vertices) continue;
      throw std::runtime_error("index " + std::to_string(i) + " names vertex " + std::to_string(indices[i]) +
                               ", but there are only " + counted(vertices, "vertex") +
                               " (both count from 0); export it again");
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
        throw std::runtime_error("the position of vertex " + std::to_string(i / 3) + " is not finite; export it again");
      }
    }
    mesh.points.insert(mesh.points.end(), positions.begin(), positions.end());
    if (mesh.vertex_count() > std::numeric_limits<std::uint32_t>::max())
      throw std::runtime_error("has too many vertices");
  }

  const std::filesystem::path& path_;
  const tinygltf::Model& model_;
};

}  // namespace

MeshFile read_gltf_mesh(const std::filesystem::path& path, const tinygltf::Model& model, int mesh) {
  return GeometryReader(path, model).read(mesh);
}

}  // namespace cagewright::host
