// SPDX-License-Identifier: BSD-3-Clause
#include "host/command/set_parameters.h"

#include <algorithm>
#include <cmath>

#include "host/command/utf8.h"
#include "host/file/file_error.h"

namespace cagewright::host {

SetParameters::SetParameters(int mesh_node, Values values, std::string label)
    : mesh_node_(mesh_node), values_(std::move(values)), label_(std::move(label)) {}

std::string SetParameters::label() const { return label_; }

void SetParameters::doIt(SceneDocument& document) {
  const auto& nodes = document.mesh_nodes();
  const auto is_it = [this](const SceneMeshNode& node) { return node.node == mesh_node_; };
  if (std::none_of(nodes.begin(), nodes.end(), is_it)) {
    throw CommandError("node " + std::to_string(mesh_node_) + " has no mesh for a cage: choose one that has");
  }
  for (const auto& [id, value] : values_) {
    if (!is_utf8(id)) throw CommandError("the name of the parameter " + in_quotes(id) + " is not UTF-8");
    if (!std::isfinite(value)) {
      throw CommandError("the parameter " + in_quotes(id) + " is not finite: give it a finite value");
    }
  }
  before_ = document.parameters(mesh_node_);
  redoIt(document);
}

void SetParameters::undoIt(SceneDocument& document) { document.set_parameters(mesh_node_, before_); }
void SetParameters::redoIt(SceneDocument& document) { document.set_parameters(mesh_node_, values_); }

}  // namespace cagewright::host
