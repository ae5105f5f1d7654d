// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_WORKSPACE_WORKSPACE_H
#define CAGEWRIGHT_HOST_WORKSPACE_WORKSPACE_H

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "host/command/command_stack.h"
#include "host/plugin_client/plugin.h"
#include "host/scene/scene_document.h"
#include "host/workspace/cage_state.h"

namespace cagewright::host {

// What has changed in a workspace, told after it has.
enum class WorkspaceChange {
  scene,   // another document, or none
  mesh,    // another mesh node is the one to cage
  slides,  // of the document, or the preview
  parameters,
  selection,
  cage,  // cage(), also its problems
  progress,
  plugin,  // loaded or unloaded
  saved,   // path, or whether there are unsaved changes
};

// A slide that is shown and solved for, but not in the document: a stroke that is being drawn, a drag.
struct PreviewSlide {
  std::int64_t id = -1;  // of the document's slide that it stands for; -1: a new one
  Slide::Ellipse ellipse;
};

// One open scene, its undo stack, the mesh that is being caged, the selected slides, and the cage, which follows the
// slides in the background. What windows and scripts have in common: neither Qt nor VTK. Main thread only; `wake` alone
// is called from another. Functions that change the document run commands on stack() and throw CommandError; those that
// read and write files FileError; those that ask the plug-in PluginError.
class Workspace {
 public:
  // `plugin` may be null: then there is no cage, and slides can be loaded, moved and saved, but not fitted. `wake` is
  // called from the solver's thread when poll() has something to do; may be empty.
  Workspace(std::shared_ptr<const Plugin> plugin, std::function<void()> wake);
  ~Workspace();
  Workspace(const Workspace&) = delete;
  Workspace& operator=(const Workspace&) = delete;

  using Listener = std::function<void(WorkspaceChange)>;
  void listen(Listener listener);  // one; called on the main thread

  // ---- file
  // Any model or scene; a model becomes a new scene, not saved yet, whose path is the model's with .glb. The first mesh
  // node with slides, else the first, is chosen. On failure everything stays.
  void open(const std::filesystem::path& path);
  // What save_copy has left of a scene: opened as that scene, with changes that are not saved. Throws FileError.
  void recover(const std::filesystem::path& copy, const std::filesystem::path& scene);
  void close();
  // As .glb or .gltf, with the cages as they are now; waits for them (Cancelled where interrupt_solve was called), but
  // after cancel_solve takes the last good ones. Path and format become the scene's; atomic.
  void save(const std::filesystem::path& path);
  bool has_to_wait_to_save() const;  // whether save would have to wait for a cage
  // The same without any change of this workspace. Does not wait; the last good cage.
  void save_copy(const std::filesystem::path& path) const;
  // save_copy as a job that no longer needs the workspace: the document and cage of now are written when it is
  // called, on any thread; external files of a .gltf are read only then. To make it takes a copy of the scene's bytes.
  // The job throws FileError.
  std::function<void()> copy_to_write(const std::filesystem::path& path) const;
  // The cage alone: .obj .off .ply .stl .glb .gltf. Throws CommandError where there is none.
  void export_cage(const std::filesystem::path& path);
  bool has_scene() const;
  const SceneDocument& document() const;          // precondition: has_scene()
  const std::filesystem::path& path() const;      // where save goes by default; empty: nothing is open
  bool has_file() const;                          // what is at path(), if anything, is this scene; false: of a model
  bool is_saved() const;                          // nothing to lose
  const std::vector<std::string>& notes() const;  // of the last open: a sentence each

  // ---- the mesh to cage
  int mesh_node() const;  // -1: none
  void choose_mesh(int node);
  const TriangleMesh& mesh() const;  // in its node's space; precondition: mesh_node() >= 0
  // Of any mesh node; read once. Null where it cannot be read (notes() has the sentence where it was tried at open).
  std::shared_ptr<const TriangleMesh> mesh_of(int node) const;
  std::vector<const SceneSlide*> slides() const;  // of that mesh node, in the document's order
  const SceneSlide* find_slide(const std::string& name) const;

  // ---- slides, one step of undo each. Names: empty asks for the next free "slide 1", "slide 2" ...
  std::int64_t add_slide(const Slide& slide);  // of any kind: fitted first; a stroke is kept with the slide
  // A stroke on the surface and the line of sight (towards the model): the plane holds both, or is tilted where that
  // runs along the body (tilted_plane.h); its loop is fitted.
  struct SlideAcross {
    std::int64_t id;
    double tilt;  // radians; 0: the plane holds both
  };
  SlideAcross add_slide_across(const std::vector<Point3>& stroke, const Point3& line_of_sight,
                               const std::string& name = "");
  void extend_stroke(std::int64_t id, const std::vector<Point3>& points);  // adds to the stroke it has, fits again
  void change_slides(const std::vector<std::pair<std::int64_t, Slide::Ellipse>>& slides, const std::string& label);
  void rename_slide(std::int64_t id, const std::string& name);
  void remove_slides(const std::vector<std::int64_t>& ids);
  // Slides that are new, here and below and above, are selected.
  std::vector<std::int64_t> duplicate_slides(const std::vector<std::int64_t>& ids);  // moved a little along normals
  // Copies on the other side of the plane x, y or z (axis 0, 1, 2) = `at` in the mesh's space; empty: the middle of
  // its box.
  std::vector<std::int64_t> mirror_slides(const std::vector<std::int64_t>& ids, int axis, std::optional<double> at);
  void snap_slides(const std::vector<std::int64_t>& ids);  // the ellipse becomes that of the loop in its plane
  std::string copy_slides(const std::vector<std::int64_t>& ids) const;  // as the text of a slides file: ellipses
  std::vector<std::int64_t> paste_slides(const std::string& text);      // of one; throws FileError where it is none
  // Has the plug-in take the mesh for fit(), in the background: else the first fit waits for it, which a million
  // triangles make long. Does nothing where there is no mesh or no plug-in.
  void prepare_to_fit();
  // What one of the above would fit; for previews. Throws as they do. Of a stroke across, not tilted.
  Slide::Ellipse fit(const Slide& slide) const;
  Slide::Ellipse fit_across(const std::vector<Point3>& stroke, const Point3& line_of_sight) const;

  // Shows these in place of those of the document until cleared or a command is run; the cage follows, for editing.
  void set_preview(std::vector<PreviewSlide> preview);
  void clear_preview();
  const std::vector<PreviewSlide>& preview() const;

  // ---- parameters of the mesh node's cage, in the plug-in's order; one step of undo each
  double parameter(const std::string& id) const;
  void set_parameter(const std::string& id, double value);
  void reset_parameters();

  // ---- undo; the mesh whose slides or parameters change is then the chosen one, and the slides that come back or
  // change are selected
  void undo();
  void redo();
  const CommandStack& stack() const;  // precondition: has_scene()

  // ---- selection: ids of slides
  void select(std::vector<std::int64_t> ids);
  const std::vector<std::int64_t>& selection() const;

  // ---- cage
  const CageState& cage() const;
  SolveProgress progress() const;
  void cancel_solve();  // the cage is not followed until the next change or solve()
  void solve();         // asks for it again
  void wait_for_cage();
  // Cancels what the solver does now, as cancel_solve does; the one function that any thread may call, so `wake` too
  // (but not while the plug-in is changed).
  void interrupt_solve();
  void poll();  // takes what the solver has; on the main thread after `wake`

  // ---- plug-in
  const std::shared_ptr<const Plugin>& plugin() const;
  void load_plugin(const std::filesystem::path& path);  // throws PluginLoadError: the one before stays
  // Throws CommandError while a scene with slides or a cage is open.
  void unload_plugin();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace cagewright::host

#endif
