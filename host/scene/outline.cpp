// SPDX-License-Identifier: BSD-3-Clause
#include "host/scene/outline.h"

#include <tiny_gltf.h>

#include "host/file/gltf_nodes.h"
#include "host/file/gltf_own_nodes.h"

namespace cagewright::host {
namespace {

bool is_own(const tinygltf::Node& node) {
  return is_slide_node(node) || is_cage_node(node) || is_empty_cage_node(node);
}

}  // namespace

std::string shown_name(const tinygltf::Model& model, const tinygltf::Node& node) {
  const bool has_mesh = node.mesh >= 0 && static_cast<std::size_t>(node.mesh) < model.meshes.size();
  return node.name.empty() && has_mesh ? model.meshes[static_cast<std::size_t>(node.mesh)].name : node.name;
}

std::vector<SceneNode> outline(const std::filesystem::path& path, const tinygltf::Model& model,
                               const SceneContent& content) {
  using Kind = SceneNode::Kind;
  const std::vector<int> parents = gltf_parents(path, model);
  const auto typed = [&](int node) -> const tinygltf::Node& { return model.nodes[static_cast<std::size_t>(node)]; };
  std::vector<SceneNode> nodes;
  for (int index = 0; index < static_cast<int>(model.nodes.size()); ++index) {
    const tinygltf::Node& node = typed(index);
    if (is_own(node)) continue;
    int parent = parents[static_cast<std::size_t>(index)];
    while (parent >= 0 && is_own(typed(parent))) parent = parents[static_cast<std::size_t>(parent)];
    nodes.push_back({shows_model(node) ? Kind::mesh : Kind::plain, index, parent, shown_name(model, node), 0});
  }
  for (const SceneSlide& slide : content.slides)
    nodes.push_back({Kind::slide, -1, slide.mesh_node, slide.name, slide.id});
  for (const SceneCage& cage : content.cages) nodes.push_back({Kind::cage, -1, cage.mesh_node, cage.name, 0});
  for (const SceneStray& stray : content.strays) nodes.push_back({Kind::stray, -1, -1, stray.name, 0});
  return nodes;
}

}  // namespace cagewright::host
