// SPDX-License-Identifier: BSD-3-Clause
#include "host/cli/cage_input.h"

#include <algorithm>
#include <utility>

#include "host/cli/input_error.h"
#include "host/file/file_error.h"
#include "host/file/mesh_reader.h"
#include "host/scene/external_files.h"

namespace cagewright::host {
namespace {

std::string text_of(const SceneMeshNode& node) {
  return std::to_string(node.node) + (node.name.empty() ? "" : " (" + in_quotes(node.name) + ")");
}

std::string list_of(const std::vector<SceneMeshNode>& nodes) {
  constexpr std::size_t most = 8;
  std::string text;
  for (std::size_t i = 0; i < std::min(nodes.size(), most); ++i) text += (i == 0 ? "" : ", ") + text_of(nodes[i]);
  return nodes.size() > most ? text + ", ..." : text;
}

class InputReader {
 public:
  explicit InputReader(const CageCommand& command) : command_(command) {}

  CageInput read() {
    if (command_.slides && is_scene_name(*command_.slides)) {
      throw InputError(command_.slides->string() +
                       ": is a scene, and no slides file: give it as MODEL, and its own slides are used");
    }
    if (command_.slides) given_ = read_slides(*command_.slides);
    const bool is_scene = is_scene_name(command_.model);
    if (command_.node && !is_scene) {
      throw UsageError("--node " + *command_.node + ": " + command_.model.string() +
                       " has no nodes; only .glb and .gltf have");
    }
    if (!is_scene || !read_scene()) read_whole();
    if (is_scene && !input_.scene && command_.out && is_scene_name(*command_.out)) {
      throw InputError(command_.model.string() +
                       ": no node has a mesh, so slides and cage have no place in the scene: give its mesh a node");
    }
    if (!command_.slides && input_.targets.size() == 1 && input_.targets.front().slides.empty()) {
      input_.notes.push_back("no slides are given, so the cage is a box; see --slides");
    }
    return std::move(input_);
  }

 private:
  void note_all(const std::vector<std::string>& notes) {
    input_.notes.insert(input_.notes.end(), notes.begin(), notes.end());
  }

  void read_whole() {
    MeshFile file = read_mesh(command_.model);
    note_all(file.notes);
    input_.targets.push_back({-1, "", std::move(file.mesh), given_});
  }

  // False where the scene's meshes are to be one.
  bool read_scene() {
    SceneDocument scene(command_.model);
    const std::vector<SceneMeshNode> chosen = choose(scene);
    if (chosen.empty()) return false;
    note_all(scene.notes());
    if (command_.out && is_scene_name(*command_.out)) {
      note_all(scene.lost_as(is_binary_scene_name(*command_.out)));
      note_all(missed_files(scene, *command_.out));
    }
    for (const SceneMeshNode& node : chosen) {
      MeshFile file = scene.mesh(node.node);
      note_all(file.notes);
      CageTarget target{node.node, chosen.size() > 1 ? "node " + text_of(node) : "", std::move(file.mesh), given_};
      if (!command_.slides) target.slides = slides_of(scene, node.node);
      input_.targets.push_back(std::move(target));
    }
    input_.slides_from_scene = !command_.slides;
    input_.scene = std::move(scene);
    return true;
  }

  static std::vector<Slide> slides_of(const SceneDocument& scene, int node) {
    std::vector<Slide> slides;
    for (const SceneSlide& slide : scene.slides()) {
      if (slide.mesh_node == node) slides.push_back({slide.name, slide.ellipse});
    }
    return slides;
  }

  std::vector<SceneMeshNode> choose(const SceneDocument& scene) const {
    const std::vector<SceneMeshNode>& nodes = scene.mesh_nodes();
    if (command_.node) return {named(nodes)};
    std::vector<SceneMeshNode> with_slides;
    for (const SceneMeshNode& node : nodes) {
      const auto cuts_it = [&](const SceneSlide& slide) { return slide.mesh_node == node.node; };
      if (std::any_of(scene.slides().begin(), scene.slides().end(), cuts_it)) with_slides.push_back(node);
    }
    if (command_.slides && with_slides.size() == 1) return with_slides;
    if (!command_.slides && !with_slides.empty()) return with_slides;
    if (nodes.size() == 1) return nodes;
    const bool is_for_scene = command_.out && is_scene_name(*command_.out);
    if (nodes.empty() || !is_for_scene) return {};
    throw InputError(command_.model.string() + ": several nodes have a mesh, " + list_of(nodes) +
                     ": say with --node which one the slides cut");
  }

  SceneMeshNode named(const std::vector<SceneMeshNode>& nodes) const {
    std::vector<SceneMeshNode> found;
    for (const SceneMeshNode& node : nodes) {
      if (node.name == *command_.node) found.push_back(node);
    }
    for (const SceneMeshNode& node : nodes) {
      if (found.empty() && std::to_string(node.node) == *command_.node) return node;
    }
    if (found.size() == 1) return found.front();
    throw InputError(command_.model.string() + ": " + (found.empty() ? "no node" : "more than one node") +
                     " with a mesh is called " + in_quotes(*command_.node) + "; there are " +
                     list_of(found.empty() ? nodes : found) + ", and a number is enough");
  }

  const CageCommand& command_;
  std::vector<Slide> given_;
  CageInput input_;
};

}  // namespace

CageInput read_cage_input(const CageCommand& command) { return InputReader(command).read(); }

}  // namespace cagewright::host
