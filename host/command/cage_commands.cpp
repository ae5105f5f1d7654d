// SPDX-License-Identifier: BSD-3-Clause
#include "host/command/cage_commands.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace cagewright::host {
namespace {

std::optional<SceneCage> cage_of(const SceneDocument& document, int mesh_node) {
  const SceneCage* cage = document.find_cage(mesh_node);
  return cage ? std::optional(*cage) : std::nullopt;
}

}  // namespace

SetCage::SetCage(SceneCage cage) : cage_(std::move(cage)) { cage_.as_read = nullptr; }
std::string SetCage::label() const { return "set the cage of node " + std::to_string(cage_.mesh_node); }
void SetCage::doIt(SceneDocument& document) {
  const std::string node = "node " + std::to_string(cage_.mesh_node);
  const auto& nodes = document.mesh_nodes();
  const auto is_it = [this](const SceneMeshNode& it) { return it.node == cage_.mesh_node; };
  if (std::none_of(nodes.begin(), nodes.end(), is_it)) {
    throw CommandError(node + " has no mesh for a cage: choose one that has");
  }
  if (cage_.mesh.triangles.empty()) throw CommandError("the cage of " + node + " has no triangles");
  for (std::size_t i = 0; i < cage_.mesh.points.size(); ++i) {
    if (std::abs(cage_.mesh.points[i]) <= double{std::numeric_limits<float>::max()}) continue;
    throw CommandError("the cage of " + node + ": vertex " + std::to_string(i / 3) +
                       " is too far out for glTF's floats: scale the model down");
  }
  before_ = cage_of(document, cage_.mesh_node);
  redoIt(document);
}
void SetCage::undoIt(SceneDocument& document) { document.set_cage(cage_.mesh_node, before_ ? &*before_ : nullptr); }
void SetCage::redoIt(SceneDocument& document) { document.set_cage(cage_.mesh_node, &cage_); }

RemoveCage::RemoveCage(int mesh_node) : mesh_node_(mesh_node) {}
std::string RemoveCage::label() const { return "remove the cage of node " + std::to_string(mesh_node_); }
void RemoveCage::doIt(SceneDocument& document) {
  removed_ = cage_of(document, mesh_node_);
  if (!removed_) throw CommandError("node " + std::to_string(mesh_node_) + " has no cage");
  redoIt(document);
}
void RemoveCage::undoIt(SceneDocument& document) { document.set_cage(mesh_node_, &*removed_); }
void RemoveCage::redoIt(SceneDocument& document) { document.set_cage(mesh_node_, nullptr); }

}  // namespace cagewright::host
