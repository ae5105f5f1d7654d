// SPDX-License-Identifier: BSD-3-Clause
#include "host/command/cage_commands.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "host/command/utf8.h"
#include "host/file/file_error.h"
#include "host/file/gltf_json.h"
#include "host/scene/slide_ids.h"

namespace cagewright::host {
namespace {

std::optional<SceneCage> cage_of(const SceneDocument& document, int mesh_node) {
  const SceneCage* cage = document.find_cage(mesh_node);
  return cage ? std::optional(*cage) : std::nullopt;
}

void check_geometry(const SceneCage& cage, const std::string& what) {
  const TriangleMesh& mesh = cage.mesh;
  if (mesh.triangles.empty()) throw CommandError(what + " has no triangles");
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    if (std::abs(mesh.points[i]) <= double{std::numeric_limits<float>::max()}) continue;
    throw CommandError(what + ": vertex " + std::to_string(i / 3) +
                       " is too far out for glTF's floats: scale the model down");
  }
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    if (mesh.triangles[i] < mesh.vertex_count()) continue;
    throw CommandError(what + ": triangle " + std::to_string(i / 3) + " names vertex " +
                       std::to_string(mesh.triangles[i]) + " of " + std::to_string(mesh.vertex_count()));
  }
}

// Read as a file's own JSON is, and not too deep to be part of it.
bool is_object_for_a_file(const std::string& text) {
  constexpr int levels_above = 16;
  const std::string within = std::string(levels_above, '[') + text + std::string(levels_above, ']');
  try {
    static_cast<void>(parse_gltf_json({}, within));
    return parse_gltf_json({}, text).is_object();
  } catch (const FileError&) {
    return false;
  }
}

// What a file holds beside the geometry.
void check_notes(const SceneCage& cage, const std::string& what) {
  if (!is_utf8(cage.name)) throw CommandError(what + ": its name " + in_quotes(cage.name) + " is not UTF-8");
  for (const auto& [id, value] : cage.parameters) {
    if (!is_utf8(id)) throw CommandError(what + ": the name of the parameter " + in_quotes(id) + " is not UTF-8");
    if (!std::isfinite(value)) {
      throw CommandError(what + ": the parameter " + in_quotes(id) + " is not finite: give it a finite value");
    }
  }
  if (std::any_of(cage.slides.begin(), cage.slides.end(),
                  [](std::int64_t id) { return id < 1 || id > largest_slide_id; })) {
    throw CommandError(what + " names a slide without an id");
  }
  if (!cage.sections.empty() && cage.sections.size() != cage.mesh.vertex_count()) {
    throw CommandError(what + " has " + counted(cage.mesh.vertex_count(), "vertex") + ", and sections for " +
                       std::to_string(cage.sections.size()));
  }
  for (std::size_t i = 0; i < cage.sections.size(); ++i) {
    if (cage.sections[i] >= -1 && cage.sections[i] < static_cast<int>(cage.slides.size())) continue;
    throw CommandError(what + ": vertex " + std::to_string(i) + " is in section " + std::to_string(cage.sections[i]) +
                       " of " + std::to_string(cage.slides.size()));
  }
  if (!cage.certificate.empty() && !is_object_for_a_file(cage.certificate)) {
    throw CommandError(what + ": its certificate is no JSON object that a file can hold");
  }
}

}  // namespace

SetCage::SetCage(SceneCage cage) : cage_(std::move(cage)) {}
std::string SetCage::label() const { return "set the cage of node " + std::to_string(cage_.mesh_node); }
void SetCage::doIt(SceneDocument& document) {
  const std::string node = "node " + std::to_string(cage_.mesh_node);
  const auto& nodes = document.mesh_nodes();
  const auto is_it = [this](const SceneMeshNode& it) { return it.node == cage_.mesh_node; };
  if (std::none_of(nodes.begin(), nodes.end(), is_it)) {
    throw CommandError(node + " has no mesh for a cage: choose one that has");
  }
  check_geometry(cage_, "the cage of " + node);
  check_notes(cage_, "the cage of " + node);
  before_ = cage_of(document, cage_.mesh_node);
  cage_.as_read = before_ ? before_->as_read : nullptr;
  cage_.is_as_read = false;
  if (before_ && cage_.name.empty()) cage_.name = before_->name;
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

RemoveStray::RemoveStray(std::size_t row) : row_(row) {}
std::string RemoveStray::label() const {
  return std::string("remove the stray ") + (removed_.is_cage ? "cage " : "slide ") + in_quotes(removed_.name);
}
void RemoveStray::doIt(SceneDocument& document) {
  if (row_ >= document.strays().size()) throw CommandError("there is no stray " + std::to_string(row_));
  removed_ = document.strays()[row_];
  redoIt(document);
}
void RemoveStray::undoIt(SceneDocument& document) { document.insert_stray(row_, removed_); }
void RemoveStray::redoIt(SceneDocument& document) { document.remove_stray(row_); }

}  // namespace cagewright::host
