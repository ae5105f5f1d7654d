// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_WORKSPACE_OPEN_SCENE_H
#define CAGEWRIGHT_HOST_WORKSPACE_OPEN_SCENE_H

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "host/command/command_stack.h"
#include "host/scene/scene_document.h"
#include "host/workspace/workspace.h"

namespace cagewright::host {

// The cage of one mesh node.
struct NodeCage {
  CageState shown;
  CageState whole;  // the last that was not for editing; where it failed, with the good one before it
  // The last good one of a drag that goes on or has just ended; and of the drag whose slides `whole` failed on: nearer
  // to them as they are now than the cage of `whole`.
  std::optional<CageState> dragged, edited;
  bool is_solved = false;      // `whole` has a cage that was made here, not read
  std::uint64_t content = 1;   // counts changes of the slides and parameters
  std::uint64_t answered = 0;  // the content that `whole` is about, failed or not

  void show_whole();  // where it failed, with the newest good cage
};

// A document and what a workspace keeps with it.
class OpenScene {
 public:
  // Any model or scene. Throws FileError, also where there are meshes and none can be read.
  static std::unique_ptr<OpenScene> read(const std::filesystem::path& path);

  OpenScene(SceneDocument read_document, std::filesystem::path save_path, std::vector<std::string> read_notes);
  OpenScene(const OpenScene&) = delete;
  OpenScene& operator=(const OpenScene&) = delete;

  SceneDocument document;
  CommandStack stack;
  std::filesystem::path path;
  std::vector<std::string> notes;
  std::uint64_t saved_state = 0;  // of the stack
  bool has_file = false;          // `path` was read or written: what is there is this scene
  int mesh_node = -1;
  std::vector<std::int64_t> selection;
  std::vector<PreviewSlide> preview;
  bool slides_changed = false, parameters_changed = false;  // since somebody was told
  int changed_node = -1;                                    // the mesh node that the last change was about
  std::vector<std::int64_t> touched;                        // slides that were added or changed, since it was cleared

  bool is_saved() const { return stack.state() == saved_state; }
  std::vector<const SceneSlide*> slides(int node) const;
  NodeCage& cage(int node);
  const std::map<int, NodeCage>& cages() const { return cages_; }
  std::vector<int> caged_nodes() const;
  // Read once. Throws FileError.
  std::shared_ptr<const TriangleMesh> mesh(int node);

 private:
  void choose_first_mesh();
  void on(const SceneEvent& event);

  std::map<int, NodeCage> cages_;
  std::map<int, std::shared_ptr<const TriangleMesh>> meshes_;
  std::unique_ptr<SceneDocument::Subscription> subscription_;
};

}  // namespace cagewright::host

#endif
