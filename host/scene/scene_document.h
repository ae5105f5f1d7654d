// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_SCENE_SCENE_DOCUMENT_H
#define CAGEWRIGHT_HOST_SCENE_SCENE_DOCUMENT_H

#include <array>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "host/scene/scene_content.h"

namespace cagewright::host {

// What has changed in a document, told after it has.
struct SceneEvent {
  enum class Kind { slide_added, slide_changed, slide_removed, cage_set, cage_removed, parameters_set };
  Kind kind;
  std::int64_t slide = 0;  // id, where it is about a slide
  int mesh_node = -1;      // of the slide, the cage or the parameters
};

// A node that shows a mesh which is no cage of ours.
struct SceneMeshNode {
  int node = -1;
  std::string name;  // the node's, else the mesh's; may be empty
};

// A row of the scene's tree, for an outliner.
struct SceneNode {
  enum class Kind { plain, mesh, slide, cage, stray };
  Kind kind = Kind::plain;
  int index = -1;   // of the file's node; -1: a slide, a cage or a stray, whose node has no number before it is saved
  int parent = -1;  // index of the node above; of a slide and a cage the mesh node; -1: none
  std::string name;
  std::int64_t slide = 0;  // a slide's id
};

// A glTF scene with its slides and cages. The file's JSON and binary chunk are the truth: only what is ours is changed,
// and a document that holds what its file held is saved as the same bytes. Changes are made by commands (host/command).
// One thread at a time.
class SceneDocument {
 public:
  // What becomes of nodes of ours that cannot be read.
  enum class Unreadable { refused, stray };

  // Throws FileError.
  explicit SceneDocument(const std::filesystem::path& path, Unreadable unreadable = Unreadable::refused);
  // From bytes that are already there; `path` is for sentences and for the files that a .gltf names.
  SceneDocument(const std::filesystem::path& path, std::string bytes, Unreadable unreadable = Unreadable::refused);
  // A new scene with one mesh node, as a .glb or .gltf. Positions become floats. Throws FileError.
  static SceneDocument of_mesh(const std::filesystem::path& path, const TriangleMesh& mesh, const std::string& name);
  // The same scene, slides and cages to be written as .glb (is_binary) or .gltf: buffer 0 moves between the binary
  // chunk and a data URI; chunks that glTF does not know do not go into a .gltf. Throws FileError.
  SceneDocument copy_as(bool is_binary) const;
  // What such a copy has no place for: a sentence each.
  std::vector<std::string> lost_as(bool is_binary) const;
  ~SceneDocument();
  SceneDocument(SceneDocument&&) noexcept;
  SceneDocument& operator=(SceneDocument&&) noexcept;

  const std::filesystem::path& path() const;
  // What had to be mended, and what the user should know: a sentence each.
  const std::vector<std::string>& notes() const;
  // In the file's order, in all scenes.
  const std::vector<SceneMeshNode>& mesh_nodes() const;
  // The tree: the nodes of others, by number, then slides, cages and strays as they are now. O(nodes).
  std::vector<SceneNode> nodes() const;
  // Where a mesh node's space is in the scene, a 4 x 4 matrix by rows: a skinned mesh is where its bind pose puts it,
  // as glTF does not look at its node. Throws FileError where there is no such node or its skin cannot be read.
  // O(nodes).
  std::array<double, 16> to_scene(int node) const;
  // The mesh of a node, in its local space. Throws FileError, also where the node has none. O(size of the mesh).
  MeshFile mesh(int node) const;

  const std::vector<SceneSlide>& slides() const;
  const std::vector<SceneCage>& cages() const;
  const std::vector<SceneStray>& strays() const;
  // The plug-in's parameters for a mesh node's cage, by id: those of the cage that the file has, or as set since. A
  // file holds them with a cage only.
  const std::vector<std::pair<std::string, double>>& parameters(int mesh_node) const;
  const SceneSlide* find_slide(std::int64_t id) const;
  const SceneCage* find_cage(int mesh_node) const;
  // An id that no slide of this document has had.
  std::int64_t new_slide_id();

  // For commands. `row` is the place among slides(), at most their count. Preconditions: ids and names are as
  // SceneContent says; replace_slide and remove_slide: the id is there.
  void insert_slide(std::size_t row, SceneSlide slide);
  void replace_slide(SceneSlide slide);
  void remove_slide(std::int64_t id);
  // Null: no cage any more.
  void set_cage(int mesh_node, const SceneCage* cage);
  void set_parameters(int mesh_node, std::vector<std::pair<std::string, double>> parameters);
  // Nothing follows strays, so no event tells of them.
  void insert_stray(std::size_t row, SceneStray stray);
  void remove_stray(std::size_t row);

  // Calls `listener` after every change until the subscription is destroyed. Listeners may not change the document.
  using Listener = std::function<void(const SceneEvent&)>;
  class Subscription;
  [[nodiscard]] std::unique_ptr<Subscription> listen(Listener listener);

  // The file's bytes as they would be saved: text on one line for .glb; a .gltf keeps lines where it had some. Throws
  // FileError.
  std::string bytes() const;
  // Whether bytes() differ from the file that was read.
  bool is_changed() const;
  // Names of files, relative to its folder, that a .gltf or .glb needs: buffers and images.
  std::vector<std::string> external_files() const;

 private:
  struct State;
  explicit SceneDocument(std::unique_ptr<State> state);
  void tell(const SceneEvent& event) const;
  std::unique_ptr<State> state_;
};

class SceneDocument::Subscription {
 public:
  explicit Subscription(std::shared_ptr<Listener> listener) : listener_(std::move(listener)) {}

 private:
  std::shared_ptr<Listener> listener_;  // the document holds it weakly
};

}  // namespace cagewright::host

#endif
