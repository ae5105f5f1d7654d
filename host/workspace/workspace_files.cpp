// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <limits>

#include "host/command/cage_commands.h"
#include "host/file/atomic_file.h"
#include "host/file/file_bytes.h"
#include "host/file/file_error.h"
#include "host/file/mesh_writer.h"
#include "host/scene/external_files.h"
#include "host/scene/scene_names.h"
#include "host/workspace/scene_cage.h"
#include "host/workspace/workspace_state.h"

namespace cagewright::host {
namespace {

constexpr std::uint64_t never_saved = std::numeric_limits<std::uint64_t>::max();  // no state of a stack

void check_scene_name(const std::filesystem::path& path) {
  if (!is_scene_name(path)) throw FileError(path, {}, "a scene is written as .glb or .gltf");
}

// All of them are wholly on disk before the first gets its name.
void write_scene(const SceneDocument& scene, const std::filesystem::path& path) {
  std::vector<std::pair<std::filesystem::path, std::string>> files = external_copies(scene, path);
  files.emplace_back(path, scene.bytes());
  std::vector<AtomicFile> written;
  for (const auto& [name, bytes] : files) {
    std::error_code error;  // where the folder cannot be made the file says so
    if (name.has_parent_path()) std::filesystem::create_directories(name.parent_path(), error);
    written.emplace_back(name, bytes);
  }
  for (AtomicFile& file : written) file.commit();
}

bool is_same(const SceneCage& a, const SceneCage& b) {
  return a.mesh.points == b.mesh.points && a.mesh.triangles == b.mesh.triangles && a.parameters == b.parameters &&
         a.slides == b.slides && a.sections == b.sections && a.certificate == b.certificate;
}

// The parameters as a file holds them: the plug-in's in its order, then those that it does not know.
std::vector<std::pair<std::string, double>> all_parameters(const std::vector<Parameter>& described,
                                                           std::vector<std::pair<std::string, double>> set) {
  std::vector<std::pair<std::string, double>> all;
  for (const Parameter& parameter : described) {
    const auto found = std::ranges::find(set, parameter.id, [](const auto& entry) { return entry.first; });
    all.emplace_back(parameter.id, found == set.end() ? parameter.default_value : found->second);
    if (found != set.end()) set.erase(found);
  }
  all.insert(all.end(), set.begin(), set.end());
  return all;
}

}  // namespace

void Workspace::State::set_scene(std::unique_ptr<OpenScene> with) {
  forget_requests();
  fitter_mesh.reset();
  scene = std::move(with);
  is_followed = true;
  for (const WorkspaceChange change :
       {WorkspaceChange::scene, WorkspaceChange::mesh, WorkspaceChange::slides, WorkspaceChange::parameters,
        WorkspaceChange::selection, WorkspaceChange::saved}) {
    tell(change);
  }
  follow();
  tell(WorkspaceChange::cage);
}

void Workspace::open(const std::filesystem::path& path) { state_->set_scene(OpenScene::read(path)); }

void Workspace::recover(const std::filesystem::path& copy, const std::filesystem::path& scene) {
  std::unique_ptr<OpenScene> open = OpenScene::read(copy);
  open->path = scene;
  open->saved_state = never_saved;
  state_->set_scene(std::move(open));
}

void Workspace::close() {
  if (state_->scene) state_->set_scene(nullptr);
}

// Cages of meshes without slides are written only where the file has one already.
SceneDocument Workspace::State::with_cages(bool is_binary) const {
  SceneDocument copy = scene->document.copy_as(is_binary);
  for (const auto& [node, cage] : scene->cages()) {
    const SceneCage* read = copy.find_cage(node);
    const auto values = all_parameters(parameters, scene->document.parameters(node));
    SceneCage made;
    if (cage.is_solved && (read != nullptr || !scene->slides(node).empty())) {
      made = scene_cage(copy, node, cage.whole.cage, cage.whole.report ? &cage.whole.report->certificate : nullptr);
      made.slides = cage.whole.section_slides;
      made.sections = cage.whole.vertex_sections;
    } else if (read != nullptr && scene->document.parameters(node) != read->parameters) {
      made = *read;
    } else {
      continue;
    }
    made.parameters = values;
    if (read == nullptr || !is_same(*read, made)) SetCage(std::move(made)).doIt(copy);
  }
  return copy;
}

bool Workspace::has_to_wait_to_save() const {
  const State& s = *state_;
  if (!s.scene || !s.solver || !s.is_followed) return false;
  return std::ranges::any_of(s.scene->cages(),
                             [](const auto& entry) { return entry.second.answered != entry.second.content; });
}

void Workspace::save(const std::filesystem::path& path) {
  OpenScene& open = state_->open_scene();
  check_scene_name(path);
  require_writable(path);
  clear_preview();
  if (state_->is_followed) {
    for (const int node : open.caged_nodes()) state_->wait_for(node);
  }
  write_scene(state_->with_cages(is_binary_scene_name(path)), path);
  open.path = path;
  open.saved_state = open.stack.state();
  open.has_file = true;
  state_->tell(WorkspaceChange::saved);
}

void Workspace::save_copy(const std::filesystem::path& path) const {
  static_cast<void>(state_->open_scene());
  check_scene_name(path);
  write_scene(state_->with_cages(is_binary_scene_name(path)), path);
}

void Workspace::export_cage(const std::filesystem::path& path) {
  OpenScene& open = state_->scene_with_mesh();
  if (state_->is_followed) state_->wait_for(open.mesh_node);
  const TriangleMesh& cage = open.cage(open.mesh_node).whole.cage;
  if (cage.triangles.empty()) throw CommandError("there is no cage to export: see the problems of its slides");
  if (lower_ending(path) == ".gltf") {
    write_atomically(path, SceneDocument::of_mesh(path, cage, path.stem().string()).bytes());
  } else {
    write_atomically(path, mesh_bytes(cage, path));
  }
}

}  // namespace cagewright::host
