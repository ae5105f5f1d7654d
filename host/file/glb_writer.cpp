// SPDX-License-Identifier: BSD-3-Clause
#include <string>

#include "host/file/file_error.h"
#include "host/file/gltf_container.h"
#include "host/file/gltf_packing.h"
#include "host/file/mesh_writer.h"

namespace cagewright::host {
namespace {

GltfJson document(const TriangleMesh& mesh, const std::string& name, const PackedMesh& packed) {
  GltfJson json;
  json["asset"] = {{"version", "2.0"}, {"generator", "Cagewright"}};
  json["scene"] = 0;
  json["scenes"] = GltfJson::array({{{"nodes", GltfJson::array({0})}}});
  json["nodes"] = GltfJson::array({{{"name", name}, {"mesh", 0}}});
  const GltfJson primitive = {{"attributes", {{"POSITION", 0}}}, {"indices", 1}, {"mode", gltf_triangles}};
  json["meshes"] = GltfJson::array({{{"name", name}, {"primitives", GltfJson::array({primitive})}}});
  json["accessors"] = GltfJson::array({{{"bufferView", 0},
                                        {"componentType", gltf_float},
                                        {"count", mesh.vertex_count()},
                                        {"type", "VEC3"},
                                        {"min", packed.least},
                                        {"max", packed.most}},
                                       {{"bufferView", 1},
                                        {"componentType", packed.index_type},
                                        {"count", mesh.triangles.size()},
                                        {"type", "SCALAR"}}});
  json["bufferViews"] = GltfJson::array(
      {{{"buffer", 0}, {"byteOffset", 0}, {"byteLength", packed.position_bytes}, {"target", gltf_array_buffer}},
       {{"buffer", 0},
        {"byteOffset", packed.position_bytes},
        {"byteLength", packed.index_bytes},
        {"target", gltf_element_array_buffer}}});
  json["buffers"] = GltfJson::array({{{"byteLength", packed.position_bytes + packed.index_bytes}}});
  return json;
}

}  // namespace

std::string glb_bytes(const TriangleMesh& mesh, const std::string& name, const std::filesystem::path& path) {
  if (mesh.triangles.empty()) throw FileError(path, {}, "cannot be written: the mesh has no triangles");
  const PackedMesh packed = pack_mesh(path, mesh);
  // A file's name need not be UTF-8.
  std::string json = document(mesh, name, packed).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  GltfContainer container;
  container.is_binary = true;
  const std::string chunk = binary_chunk(packed.bytes);
  container.chunks = chunk;
  return join_gltf(path, container, std::move(json));
}

}  // namespace cagewright::host
