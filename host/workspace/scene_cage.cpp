// SPDX-License-Identifier: BSD-3-Clause
#include "host/workspace/scene_cage.h"

#include <algorithm>

#include "host/file/gltf_json.h"
#include "host/scene/mesh_fingerprint.h"

namespace cagewright::host {
namespace {

std::string name_for_cage(const SceneDocument& scene, int node) {
  const auto& nodes = scene.mesh_nodes();
  const auto it = std::find_if(nodes.begin(), nodes.end(), [&](const SceneMeshNode& n) { return n.node == node; });
  return it == nodes.end() || it->name.empty() ? "cage" : it->name + " cage";
}

bool is_in_floats(const TriangleMesh& mesh) {
  return std::all_of(mesh.points.begin(), mesh.points.end(),
                     [](double value) { return value == static_cast<double>(static_cast<float>(value)); });
}

}  // namespace

SceneCage scene_cage(const SceneDocument& scene, int mesh_node, const TriangleMesh& cage,
                     const Report::Certificate* certificate) {
  SceneCage result;
  result.mesh_node = mesh_node;
  if (scene.find_cage(mesh_node) == nullptr) result.name = name_for_cage(scene, mesh_node);
  result.mesh = cage;
  if (certificate != nullptr && is_in_floats(cage)) {
    GltfJson json = parse_gltf_json({}, certificate_text(*certificate));
    json["of"] = {{"model", mesh_fingerprint(scene.mesh(mesh_node).mesh)}, {"cage", mesh_fingerprint(cage)}};
    result.certificate = gltf_json_text(json);
  }
  return result;
}

}  // namespace cagewright::host
