// SPDX-License-Identifier: BSD-3-Clause
//
// The parameters of a cage: kept by the document, described and bounded by the plug-in.
#include <cmath>
#include <sstream>

#include "host/command/set_parameters.h"
#include "host/file/file_error.h"
#include "host/workspace/workspace_state.h"

namespace cagewright::host {
namespace {

const std::pair<std::string, double>* find_value(const SetParameters::Values& values, const std::string& id) {
  for (const auto& value : values) {
    if (value.first == id) return &value;
  }
  return nullptr;
}

std::string bound_text(double bound) {
  std::ostringstream text;
  text << bound;
  return text.str();
}

void check_value(const Parameter& parameter, double value) {
  if (!(value >= parameter.minimum && value <= parameter.maximum) || !std::isfinite(value)) {
    throw CommandError("the parameter " + in_quotes(parameter.id) + " has to be from " + bound_text(parameter.minimum) +
                       " to " + bound_text(parameter.maximum));
  }
  if (parameter.type != CGW_PARAM_REAL && value != std::round(value)) {
    throw CommandError("the parameter " + in_quotes(parameter.id) + " has to be a whole number");
  }
}

}  // namespace

double Workspace::parameter(const std::string& id) const {
  const Parameter& parameter = state_->parameter(id);
  if (mesh_node() < 0) return parameter.default_value;
  const auto* value = find_value(state_->scene->document.parameters(mesh_node()), id);
  return value ? value->second : parameter.default_value;
}

void Workspace::set_parameter(const std::string& id, double value) {
  const OpenScene& open = state_->scene_with_mesh();
  const Parameter& described = state_->parameter(id);
  check_value(described, value);
  if (parameter(id) == value) return;
  SetParameters::Values values = open.document.parameters(open.mesh_node);
  std::erase_if(values, [&](const auto& entry) { return entry.first == id; });
  values.emplace_back(id, value);
  state_->run(std::make_unique<SetParameters>(open.mesh_node, std::move(values), "set " + described.label));
}

// Those that this plug-in does not know stay: another one does.
void Workspace::reset_parameters() {
  const OpenScene& open = state_->scene_with_mesh();
  SetParameters::Values values = open.document.parameters(open.mesh_node);
  bool changes = false;
  for (const Parameter& parameter : state_->parameters) {
    changes = changes || this->parameter(parameter.id) != parameter.default_value;
    std::erase_if(values, [&](const auto& entry) { return entry.first == parameter.id; });
  }
  if (!changes) return;
  state_->run(std::make_unique<SetParameters>(open.mesh_node, std::move(values), "reset the parameters"));
}

}  // namespace cagewright::host
