// SPDX-License-Identifier: BSD-3-Clause
#include "host/workspace/workspace.h"

#include <algorithm>

#include "host/command/set_parameters.h"
#include "host/file/file_error.h"
#include "host/plugin_client/plugin_error.h"
#include "host/workspace/workspace_state.h"

namespace cagewright::host {

OpenScene& Workspace::State::open_scene() const {
  if (!scene) throw CommandError("no scene is open: open one first");
  return *scene;
}

OpenScene& Workspace::State::scene_with_mesh() const {
  OpenScene& open = open_scene();
  if (open.mesh_node < 0) throw CommandError("the scene has no mesh to cut: open one that has");
  return open;
}

const SceneSlide& Workspace::State::slide(std::int64_t id) const {
  const SceneSlide* slide = open_scene().document.find_slide(id);
  if (slide == nullptr) throw CommandError("there is no slide with the id " + std::to_string(id));
  return *slide;
}

const Parameter& Workspace::State::parameter(const std::string& id) const {
  if (!plugin) throw CommandError("no plug-in is loaded, so there are no parameters: load one");
  const auto is_it = [&](const Parameter& parameter) { return parameter.id == id; };
  const auto found = std::find_if(parameters.begin(), parameters.end(), is_it);
  if (found == parameters.end()) throw CommandError("the plug-in has no parameter " + in_quotes(id));
  return *found;
}

void Workspace::State::set_plugin(std::shared_ptr<const Plugin> with) {
  std::vector<Parameter> its = with ? with->parameters() : std::vector<Parameter>();
  solver.reset();  // before the plug-in that it uses
  fitter.reset();
  asked.clear();
  plugin = std::move(with);
  parameters = std::move(its);
  if (plugin) {
    solver = std::make_unique<CageSolver>(plugin, wake);
    fitter = std::make_unique<SlideFitter>(plugin);
  }
  if (scene) {
    for (const int node : scene->caged_nodes()) scene->cage(node).answered = 0;
  }
}

void Workspace::State::run(std::unique_ptr<Command> command) {
  OpenScene& open = open_scene();
  const bool was_saved = open.is_saved();
  open.stack.run(std::move(command));
  follow_document();
  if (open.is_saved() != was_saved) tell(WorkspaceChange::saved);
}

void Workspace::State::follow_document() {
  OpenScene& open = *scene;
  const bool had_preview = !open.preview.empty();
  open.preview.clear();
  is_followed = true;
  const std::size_t selected = open.selection.size();
  std::erase_if(open.selection, [&](std::int64_t id) { return open.document.find_slide(id) == nullptr; });
  follow();
  if (std::exchange(open.slides_changed, false) || had_preview) tell(WorkspaceChange::slides);
  if (std::exchange(open.parameters_changed, false)) tell(WorkspaceChange::parameters);
  if (open.selection.size() != selected) tell(WorkspaceChange::selection);
}

void Workspace::State::select(std::vector<std::int64_t> ids) {
  if (scene->selection == ids) return;
  scene->selection = std::move(ids);
  tell(WorkspaceChange::selection);
}

Workspace::Workspace(std::shared_ptr<const Plugin> plugin, std::function<void()> wake)
    : state_(std::make_unique<State>()) {
  state_->wake = std::move(wake);
  state_->set_plugin(std::move(plugin));
}

Workspace::~Workspace() = default;

void Workspace::listen(Listener listener) { state_->listener = std::move(listener); }

bool Workspace::has_scene() const { return state_->scene != nullptr; }
const SceneDocument& Workspace::document() const { return state_->open_scene().document; }
const CommandStack& Workspace::stack() const { return state_->open_scene().stack; }
bool Workspace::has_file() const { return state_->scene && state_->scene->has_file; }

bool Workspace::is_saved() const { return !state_->scene || state_->scene->is_saved(); }

const std::filesystem::path& Workspace::path() const {
  static const std::filesystem::path none;
  return state_->scene ? state_->scene->path : none;
}

const std::vector<std::string>& Workspace::notes() const {
  static const std::vector<std::string> none;
  return state_->scene ? state_->scene->notes : none;
}

int Workspace::mesh_node() const { return state_->scene ? state_->scene->mesh_node : -1; }

void Workspace::State::choose_mesh(int node) {
  OpenScene& open = *scene;
  poll();
  const bool had_selection = !open.selection.empty();
  open.preview.clear();
  open.selection.clear();
  open.mesh_node = node;
  is_followed = true;
  for (const WorkspaceChange change : {WorkspaceChange::mesh, WorkspaceChange::slides, WorkspaceChange::parameters}) {
    tell(change);
  }
  if (had_selection) tell(WorkspaceChange::selection);
  follow();
  tell(WorkspaceChange::cage);
}

void Workspace::choose_mesh(int node) {
  OpenScene& open = state_->open_scene();
  const auto& nodes = open.document.mesh_nodes();
  if (std::none_of(nodes.begin(), nodes.end(), [&](const SceneMeshNode& it) { return it.node == node; })) {
    throw CommandError("node " + std::to_string(node) + " has no mesh to cage: choose one that has");
  }
  static_cast<void>(open.mesh(node));
  if (open.mesh_node != node) state_->choose_mesh(node);
}

const TriangleMesh& Workspace::mesh() const { return *state_->scene_with_mesh().mesh(mesh_node()); }

std::shared_ptr<const TriangleMesh> Workspace::mesh_of(int node) const {
  try {
    return state_->open_scene().mesh(node);
  } catch (const FileError&) {
    return nullptr;
  }
}

std::vector<const SceneSlide*> Workspace::slides() const {
  return state_->scene ? state_->scene->slides(state_->scene->mesh_node) : std::vector<const SceneSlide*>();
}

const SceneSlide* Workspace::find_slide(const std::string& name) const {
  for (const SceneSlide* slide : slides()) {
    if (slide->name == name) return slide;
  }
  return nullptr;
}

void Workspace::State::step(bool (CommandStack::*undo_or_redo)()) {
  OpenScene& open = open_scene();
  const bool was_saved = open.is_saved();
  open.changed_node = open.mesh_node;
  open.touched.clear();
  if (!(open.stack.*undo_or_redo)()) return;
  std::vector<std::int64_t> touched = std::exchange(open.touched, {});
  follow_document();
  if (open.changed_node != open.mesh_node) choose_mesh(open.changed_node);
  std::erase_if(touched, [&](std::int64_t id) { return open.document.find_slide(id) == nullptr; });
  if (!touched.empty()) select(std::move(touched));
  if (open.is_saved() != was_saved) tell(WorkspaceChange::saved);
}

void Workspace::undo() { state_->step(&CommandStack::undo); }
void Workspace::redo() { state_->step(&CommandStack::redo); }

void Workspace::select(std::vector<std::int64_t> ids) {
  if (!state_->scene) return;
  for (const std::int64_t id : ids) static_cast<void>(state_->slide(id));
  state_->select(std::move(ids));
}

const std::vector<std::int64_t>& Workspace::selection() const {
  static const std::vector<std::int64_t> none;
  return state_->scene ? state_->scene->selection : none;
}

const std::shared_ptr<const Plugin>& Workspace::plugin() const { return state_->plugin; }

void Workspace::load_plugin(const std::filesystem::path& path) {
  state_->set_plugin(Plugin::load(path));
  state_->tell(WorkspaceChange::plugin);
  state_->tell(WorkspaceChange::parameters);
  state_->follow();
}

void Workspace::unload_plugin() {
  const OpenScene* open = state_->scene.get();
  if (open != nullptr && (!open->document.slides().empty() || !open->document.cages().empty())) {
    throw CommandError("the scene has slides or a cage, which the plug-in makes: close it first");
  }
  state_->set_plugin(nullptr);
  state_->tell(WorkspaceChange::plugin);
  state_->tell(WorkspaceChange::parameters);
  state_->tell(WorkspaceChange::progress);
}

}  // namespace cagewright::host
