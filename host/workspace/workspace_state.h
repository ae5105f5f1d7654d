// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_WORKSPACE_WORKSPACE_STATE_H
#define CAGEWRIGHT_HOST_WORKSPACE_WORKSPACE_STATE_H

#include <map>
#include <utility>

#include "host/workspace/cage_solver.h"
#include "host/workspace/open_scene.h"
#include "host/workspace/slide_fitter.h"
#include "host/workspace/workspace.h"

namespace cagewright::host {

// The cage of a mesh node as a file is to hold it, apart from the workspace.
struct CageToSave {
  int mesh_node = -1;
  bool is_made = false;  // here: the last good one; false: as it was read, if any
  bool has_slides = false;
  TriangleMesh mesh;
  std::vector<std::int64_t> slides;
  std::vector<int> sections;
  std::shared_ptr<const Report> report;
  using Parameters = std::vector<std::pair<std::string, double>>;
  Parameters set_parameters, parameters;  // the document's; all of them
};

struct Workspace::State {
  std::shared_ptr<const Plugin> plugin;
  std::vector<Parameter> parameters;  // of the plug-in
  std::function<void()> wake;
  Listener listener;
  std::unique_ptr<OpenScene> scene;  // null: nothing is open
  std::unique_ptr<CageSolver> solver;
  bool is_followed = true;  // false: cancelled, until the next change
  struct Asked {
    int mesh_node = -1;
    bool editing = false;
    std::uint64_t content = 0;
  };
  std::uint64_t last_request = 0;
  std::map<std::uint64_t, Asked> asked;  // requests that are not answered, by revision
  std::unique_ptr<SlideFitter> fitter;   // null where there is no plug-in

  void tell(WorkspaceChange change) const {
    if (listener) listener(change);
  }
  void set_plugin(std::shared_ptr<const Plugin> plugin);

  // Throw CommandError: nothing is open; there is no mesh to cut.
  OpenScene& open_scene() const;
  OpenScene& scene_with_mesh() const;
  const SceneSlide& slide(std::int64_t id) const;
  const Parameter& parameter(const std::string& id) const;

  // A command, and what follows from it.
  void run(std::unique_ptr<Command> command);
  void run_group(const std::string& label, std::vector<std::unique_ptr<Command>> commands);
  // After the document has changed: tells of it and asks for its cage.
  void follow_document();
  void step(bool (CommandStack::*undo_or_redo)());
  void choose_mesh(int node);
  void select(std::vector<std::int64_t> ids);
  void set_scene(std::unique_ptr<OpenScene> scene);

  // The cage: asks for it as things are now, where it is not there yet.
  void follow();
  void follow_others();  // asks for the next cage of a mesh that is not chosen and was changed
  // False where there is nothing to solve: the mesh cannot be read.
  bool ask(int mesh_node, bool editing);
  SolveRequest request_for(int mesh_node, bool editing) const;
  void take(SolveResult result);
  void poll();
  void forget_requests();  // those that are not answered
  // Until the mesh node's whole cage is there or has failed. Throws Cancelled where it was interrupted.
  void wait_for(int mesh_node);
  std::vector<CageToSave> cages_to_save() const;
};

}  // namespace cagewright::host

#endif
