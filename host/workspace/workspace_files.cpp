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

// Cages of meshes without slides are written only where the file has one already, or for the parameters that they hold.
void put_cages(SceneDocument& document, const std::vector<CageToSave>& cages) {
  for (const CageToSave& cage : cages) {
    const SceneCage* read = document.find_cage(cage.mesh_node);
    SceneCage made;
    if (cage.is_made && (read != nullptr || cage.has_slides || !cage.set_parameters.empty())) {
      made = scene_cage(document, cage.mesh_node, cage.mesh, cage.report ? &cage.report->certificate : nullptr);
      made.slides = cage.slides;
      made.sections = cage.sections;
    } else if (read != nullptr && cage.set_parameters != read->parameters) {
      made = *read;
    } else {
      continue;
    }
    made.parameters = cage.parameters;
    if (read == nullptr || !is_same(*read, made)) SetCage(std::move(made)).doIt(document);
  }
}

}  // namespace

void Workspace::State::set_scene(std::unique_ptr<OpenScene> with) {
  forget_requests();
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

std::vector<CageToSave> Workspace::State::cages_to_save() const {
  std::vector<CageToSave> all;
  for (const auto& [node, cage] : scene->cages()) {
    CageToSave it;
    it.mesh_node = node;
    it.is_made = cage.is_solved;
    it.has_slides = !scene->slides(node).empty();
    it.set_parameters = scene->document.parameters(node);
    it.parameters = all_parameters(parameters, it.set_parameters);
    if (it.is_made) {
      it.mesh = cage.whole.cage;
      it.slides = cage.whole.section_slides;
      it.sections = cage.whole.vertex_sections;
      it.report = cage.whole.report;
    }
    all.push_back(std::move(it));
  }
  return all;
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
  SceneDocument with_cages = open.document.copy_as(is_binary_scene_name(path));
  put_cages(with_cages, state_->cages_to_save());
  write_scene(with_cages, path);
  open.path = path;
  open.saved_state = open.stack.state();
  open.has_file = true;
  state_->tell(WorkspaceChange::saved);
}

void Workspace::save_copy(const std::filesystem::path& path) const { copy_to_write(path)(); }

// To read the bytes again is most of the work, and is done where the job is.
std::function<void()> Workspace::copy_to_write(const std::filesystem::path& path) const {
  const OpenScene& open = state_->open_scene();
  check_scene_name(path);
  return [path, from = open.document.path(), bytes = open.document.bytes(), cages = state_->cages_to_save()] {
    SceneDocument copy =
        SceneDocument(from, bytes, SceneDocument::Unreadable::stray).copy_as(is_binary_scene_name(path));
    put_cages(copy, cages);
    write_scene(copy, path);
  };
}

void Workspace::export_cage(const std::filesystem::path& path) {
  OpenScene& open = state_->scene_with_mesh();
  const bool is_text_scene = lower_ending(path) == ".gltf";
  if (!is_text_scene && !is_writable_mesh_name(path))
    throw FileError(path, {}, "a cage is exported as .obj, .off, .ply, .stl, .glb or .gltf");
  if (state_->is_followed) state_->wait_for(open.mesh_node);
  const TriangleMesh& cage = open.cage(open.mesh_node).whole.cage;
  if (cage.triangles.empty()) throw CommandError("there is no cage to export: see the problems of its slides");
  if (is_text_scene) {
    write_atomically(path, SceneDocument::of_mesh(path, cage, path.stem().string()).bytes());
  } else {
    write_atomically(path, mesh_bytes(cage, path));
  }
}

}  // namespace cagewright::host
