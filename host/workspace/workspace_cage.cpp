// SPDX-License-Identifier: BSD-3-Clause
//
// The cage that follows the slides.
#include <algorithm>

#include "host/file/file_error.h"
#include "host/plugin_client/plugin_error.h"
#include "host/workspace/slide_names.h"
#include "host/workspace/workspace_state.h"

namespace cagewright::host {

SolveRequest Workspace::State::request_for(int mesh_node, bool editing) const {
  OpenScene& open = *scene;
  SolveRequest request;
  request.mesh_node = mesh_node;
  request.mesh = open.mesh(mesh_node);
  request.editing = editing;
  const std::vector<const SceneSlide*> slides = open.slides(mesh_node);
  for (const SceneSlide* slide : slides) request.slides.emplace_back(slide->id, Slide{slide->name, slide->ellipse});
  if (editing) {
    SlideNames names(slides);
    for (const PreviewSlide& preview : open.preview) {
      const auto shown = std::ranges::find(request.slides, preview.id, [](const auto& entry) { return entry.first; });
      if (preview.id >= 0 && shown != request.slides.end()) {
        shown->second.shape = preview.ellipse;
      } else {
        request.slides.emplace_back(-1, Slide{names.like("new slide"), preview.ellipse});
      }
    }
  }
  for (const Parameter& parameter : parameters) {
    for (const auto& [id, value] : open.document.parameters(mesh_node)) {
      if (id == parameter.id && value != parameter.default_value) request.parameters.emplace_back(id, value);
    }
  }
  return request;
}

bool Workspace::State::ask(int mesh_node, bool editing) {
  NodeCage& node = scene->cage(mesh_node);
  try {
    SolveRequest request = request_for(mesh_node, editing);
    request.revision = ++last_request;
    request.asked = std::chrono::steady_clock::now();
    asked[request.revision] = {mesh_node, editing, node.content};
    solver->request(std::move(request));
  } catch (const FileError& error) {
    node.whole.problems = {{error.what(), {}, {}}};
    node.whole.failed = true;
    node.show_whole();
    node.answered = node.content;
    return false;
  }
  tell(WorkspaceChange::progress);
  return true;
}

void Workspace::State::follow() {
  if (!scene || scene->mesh_node < 0 || !is_followed) return;
  NodeCage& node = scene->cage(scene->mesh_node);
  const bool is_editing = !scene->preview.empty();
  if (!is_editing && node.answered == node.content) {
    // What was shown while editing, or is still being made, is not of now.
    forget_requests();
    node.show_whole();
    tell(WorkspaceChange::cage);
    return;
  }
  const bool was_of_now = std::exchange(node.shown.is_of_now, false);
  if (solver) ask(scene->mesh_node, is_editing);
  if (was_of_now) tell(WorkspaceChange::cage);
}

void Workspace::State::follow_others() {
  if (!scene || !is_followed || !asked.empty()) return;
  for (const int mesh_node : scene->caged_nodes()) {
    const NodeCage& node = scene->cage(mesh_node);
    if (mesh_node != scene->mesh_node && node.answered != node.content && ask(mesh_node, false)) return;
  }
}

void Workspace::State::take(SolveResult result) {
  const bool is_latest = result.revision == last_request;
  const auto request = asked.find(result.revision);
  const std::uint64_t content = request == asked.end() ? 0 : request->second.content;
  asked.erase(asked.begin(), asked.upper_bound(result.revision));
  if (result.was_cancelled || content == 0 || !scene) return;
  NodeCage& node = scene->cage(result.mesh_node);
  const bool is_editing = result.state.is_of_editing;
  const bool shows = result.mesh_node == scene->mesh_node && (!is_editing || !scene->preview.empty());
  if (is_editing && !shows) return;
  CageState& last = is_editing ? node.shown : node.whole;
  if (result.state.failed) {
    last.problems = std::move(result.state.problems);
    last.failed = true;
    last.is_of_now = false;
    last.asked = result.state.asked;
    if (!is_editing && node.dragged) node.edited = std::exchange(node.dragged, std::nullopt);
  } else {
    last = std::move(result.state);
    last.is_of_now = is_latest && content == node.content;
    node.is_solved = node.is_solved || !is_editing;
    if (!is_editing) node.edited.reset();
    node.dragged = is_editing ? std::optional(last) : std::nullopt;
  }
  if (!is_editing) {
    node.answered = content;
    if (!shows || scene->preview.empty()) node.show_whole();
  }
  if (shows) tell(WorkspaceChange::cage);
}

void Workspace::State::poll() {
  if (!solver) return;
  if (std::optional<SolveResult> result = solver->take_result()) take(std::move(*result));
  follow_others();
  tell(WorkspaceChange::progress);
}

void Workspace::State::forget_requests() {
  if (solver) solver->cancel();
  asked.clear();
}

void Workspace::State::wait_for(int mesh_node) {
  const NodeCage& node = scene->cage(mesh_node);
  if (!solver || node.answered == node.content) return;
  const auto last = asked.find(last_request);
  const bool is_asked = last != asked.end() && last->second.mesh_node == mesh_node && !last->second.editing &&
                        last->second.content == node.content;
  if (!is_asked && !ask(mesh_node, false)) return;
  solver->wait();
  poll();
  if (node.answered != node.content) throw Cancelled();
}

const CageState& Workspace::cage() const {
  static const CageState none;
  const State& s = *state_;
  return s.scene && s.scene->mesh_node >= 0 ? s.scene->cage(s.scene->mesh_node).shown : none;
}

SolveProgress Workspace::progress() const { return state_->solver ? state_->solver->progress() : SolveProgress(); }

void Workspace::cancel_solve() {
  if (!state_->solver) return;
  state_->is_followed = false;
  state_->forget_requests();
  state_->tell(WorkspaceChange::progress);
}

void Workspace::solve() {
  OpenScene& open = state_->scene_with_mesh();
  if (!state_->plugin) throw CommandError("the plug-in makes cages, and none is loaded: load one");
  state_->is_followed = true;
  open.cage(open.mesh_node).answered = 0;
  state_->follow();
}

void Workspace::wait_for_cage() {
  if (!state_->solver) return;
  state_->solver->wait();
  state_->poll();
}

void Workspace::interrupt_solve() {
  if (state_->solver) state_->solver->cancel();
}

void Workspace::poll() { state_->poll(); }

void Workspace::set_preview(std::vector<PreviewSlide> preview) {
  OpenScene& open = state_->scene_with_mesh();
  if (preview.empty()) return clear_preview();
  open.preview = std::move(preview);
  state_->is_followed = true;
  state_->follow();
  state_->tell(WorkspaceChange::slides);
}

void Workspace::clear_preview() {
  if (!state_->scene || state_->scene->preview.empty()) return;
  state_->scene->preview.clear();
  if (state_->scene->mesh_node >= 0) state_->scene->cage(state_->scene->mesh_node).dragged.reset();  // it was given up
  state_->follow();
  state_->tell(WorkspaceChange::slides);
}

const std::vector<PreviewSlide>& Workspace::preview() const {
  static const std::vector<PreviewSlide> none;
  return state_->scene ? state_->scene->preview : none;
}

}  // namespace cagewright::host
