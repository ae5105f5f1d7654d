// SPDX-License-Identifier: BSD-3-Clause
#include "host/app/view_sync.h"

#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "host/workspace/find_problem.h"

namespace cagewright::host {
namespace {

const PreviewSlide* preview_of(const Workspace& workspace, std::int64_t id) {
  for (const PreviewSlide& slide : workspace.preview())
    if (slide.id == id) return &slide;
  return nullptr;
}

}  // namespace

void ViewSync::update(WorkspaceChange change) {
  switch (change) {
    case WorkspaceChange::scene:
    case WorkspaceChange::mesh:
      show_meshes();
      show_cage();
      show_open_edges();
      show_slides();
      break;
    case WorkspaceChange::slides:
    case WorkspaceChange::selection:
      show_slides();
      break;
    case WorkspaceChange::cage:
      show_cage();
      show_open_edges();
      show_slides();
      break;
    case WorkspaceChange::parameters:
    case WorkspaceChange::progress:
    case WorkspaceChange::plugin:
    case WorkspaceChange::saved:
      break;
  }
}

void ViewSync::show_meshes() {
  coloured_by_.reset();
  std::vector<ShownMesh> shown;
  if (workspace_.has_scene()) {
    const SceneDocument& document = workspace_.document();
    for (const SceneMeshNode& node : document.mesh_nodes()) {
      const std::shared_ptr<const TriangleMesh> mesh = workspace_.mesh_of(node.node);
      if (mesh) shown.push_back({node.node, mesh, document.to_scene(node.node), node.node == workspace_.mesh_node()});
    }
  }
  view_.set_meshes(std::move(shown));
}

void ViewSync::show_slides() {
  std::vector<ShownSlide> shown;
  std::set<std::string> said;
  const auto is_selected_slide = [&](std::int64_t id) { return std::ranges::count(workspace_.selection(), id) > 0; };
  if (workspace_.has_scene())
    for (const SceneSlide* slide : workspace_.slides()) {
      const bool is_selected = is_selected_slide(slide->id);
      const Problem* found = find_problem(workspace_.cage(), slide->id);
      const std::string problem = found ? found->sentence : "";
      const PreviewSlide* preview = preview_of(workspace_, slide->id);
      // A sentence about two slides stands beside the first of them, of those that are selected.
      const bool is_of_selected =
          found && std::ranges::any_of(found->slides, [&](std::int64_t id) { return is_selected_slide(id); });
      const bool is_said = !problem.empty() && (is_selected || !is_of_selected) && said.insert(problem).second;
      const std::string label = is_said ? problem : is_selected ? slide->name : "";
      shown.push_back({slide->id, label, preview ? preview->ellipse : slide->ellipse, is_selected, preview != nullptr,
                       !problem.empty()});
    }
  for (const PreviewSlide& preview : workspace_.preview())
    if (preview.id < 0) shown.push_back({-1, "", preview.ellipse, false, true, false});
  view_.set_slides(std::move(shown));
  show_handles();
}

void ViewSync::show_handles() {
  if (handles_.is_dragging()) return;
  std::vector<std::pair<std::int64_t, Slide::Ellipse>> held;
  if (workspace_.has_scene())
    for (const std::int64_t id : workspace_.selection())
      if (const SceneSlide* slide = workspace_.document().find_slide(id);
          slide && slide->mesh_node == workspace_.mesh_node())
        held.emplace_back(id, slide->ellipse);
  handles_.set_slides(std::move(held));
}

// Where the model itself gives no cage it may be open; a closed one has no such edges.
void ViewSync::show_open_edges() {
  const CageState& cage = workspace_.cage();
  const auto is_of_model = [](const Problem& problem) { return problem.slides.empty(); };
  view_.show_open_edges(cage.failed && std::ranges::any_of(cage.problems, is_of_model));
}

void ViewSync::show_cage() {
  const CageState& cage = workspace_.cage();
  if (cage.cage.triangles.empty()) {
    view_.set_cage(nullptr);
    view_.set_outside({});
    coloured_by_.reset();
    return;
  }
  // While something is dragged the cage is always a little behind, and would flicker.
  const bool follows = cage.is_of_editing && !workspace_.preview().empty();
  ShownCage shown{cage.cage, {}, cage.failed || !(cage.is_of_now || follows)};
  for (std::size_t i = 0; i < cage.sections.size(); ++i)
    if (i >= cage.sections_merged.size() || !cage.sections_merged[i]) shown.sections.push_back(cage.sections[i]);
  view_.set_cage(&shown);
  if (cage.report == coloured_by_ || !cage.report) return;
  coloured_by_ = cage.report;
  if (!cage.cut_model.triangles.empty()) view_.set_parts(cage.cut_model, cage.cut_model_parts);
  if (cage.certificate) view_.set_outside(cage.certificate->vertices_outside);
}

}  // namespace cagewright::host
