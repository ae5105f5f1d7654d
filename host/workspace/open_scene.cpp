// SPDX-License-Identifier: BSD-3-Clause
#include "host/workspace/open_scene.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "host/file/file_error.h"
#include "host/file/mesh_reader.h"
#include "host/scene/scene_names.h"

namespace cagewright::host {

std::unique_ptr<OpenScene> OpenScene::read(const std::filesystem::path& path) {
  std::unique_ptr<OpenScene> scene;
  if (is_scene_name(path)) {
    SceneDocument document(path, SceneDocument::Unreadable::stray);
    std::vector<std::string> notes = document.notes();
    scene = std::make_unique<OpenScene>(std::move(document), path, std::move(notes));
    scene->has_file = true;
  } else {
    MeshFile file = read_mesh(path);
    std::filesystem::path scene_path = path;
    scene_path.replace_extension(".glb");
    scene = std::make_unique<OpenScene>(SceneDocument::of_mesh(scene_path, file.mesh, path.stem().string()), scene_path,
                                        std::move(file.notes));
  }
  scene->choose_first_mesh();
  return scene;
}

OpenScene::OpenScene(SceneDocument read_document, std::filesystem::path save_path, std::vector<std::string> read_notes)
    : document(std::move(read_document)), stack(document), path(std::move(save_path)), notes(std::move(read_notes)) {
  subscription_ = document.listen([this](const SceneEvent& event) { on(event); });
}

void OpenScene::on(const SceneEvent& event) {
  const bool is_of_parameters = event.kind == SceneEvent::Kind::parameters_set;
  (is_of_parameters ? parameters_changed : slides_changed) = true;
  changed_node = event.mesh_node;
  using Kind = SceneEvent::Kind;
  const bool is_touch = event.kind == Kind::slide_added || event.kind == Kind::slide_changed;
  if (is_touch && std::ranges::find(touched, event.slide) == touched.end()) touched.push_back(event.slide);
  ++cage(event.mesh_node).content;
}

std::vector<const SceneSlide*> OpenScene::slides(int node) const {
  std::vector<const SceneSlide*> slides;
  for (const SceneSlide& slide : document.slides()) {
    if (slide.mesh_node == node) slides.push_back(&slide);
  }
  return slides;
}

void NodeCage::show_whole() {
  if (!whole.failed) edited.reset();
  if (!edited) {
    shown = whole;
    return;
  }
  shown = *edited;
  shown.problems = whole.problems;
  shown.asked = whole.asked;
  shown.failed = true;
  shown.is_of_now = false;
}

// Before the first solve the cage is that of the file.
NodeCage& OpenScene::cage(int node) {
  const auto [entry, is_new] = cages_.try_emplace(node);
  if (const SceneCage* read = document.find_cage(node); is_new && read != nullptr) {
    entry->second.shown.cage = read->mesh;
    entry->second.whole = entry->second.shown;
  }
  return entry->second;
}

std::vector<int> OpenScene::caged_nodes() const {
  std::vector<int> nodes;
  for (const auto& [node, cage] : cages_) nodes.push_back(node);
  return nodes;
}

std::shared_ptr<const TriangleMesh> OpenScene::mesh(int node) {
  std::shared_ptr<const TriangleMesh>& mesh = meshes_[node];
  if (!mesh) {
    MeshFile file = document.mesh(node);
    notes.insert(notes.end(), file.notes.begin(), file.notes.end());
    mesh = std::make_shared<const TriangleMesh>(std::move(file.mesh));
  }
  return mesh;
}

void OpenScene::choose_first_mesh() {
  std::vector<int> nodes;
  for (const SceneMeshNode& node : document.mesh_nodes()) nodes.push_back(node.node);
  std::stable_partition(nodes.begin(), nodes.end(), [this](int node) { return !slides(node).empty(); });
  std::optional<FileError> first_error;
  for (const int node : nodes) {
    try {
      static_cast<void>(mesh(node));
      mesh_node = node;
      return;
    } catch (const FileError& error) {
      notes.emplace_back(error.what());
      if (!first_error) first_error = error;
    }
  }
  if (first_error) throw *first_error;
  notes.push_back(document.path().string() + ": no node has a mesh, so there is nothing to cage");
}

}  // namespace cagewright::host
