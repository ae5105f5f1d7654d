// SPDX-License-Identifier: BSD-3-Clause
#include "host/tests/scene/scene_files.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "host/command/cage_commands.h"
#include "host/command/command_stack.h"
#include "host/command/slide_commands.h"
#include "host/file/file_bytes.h"
#include "host/file/gltf_container.h"

namespace cagewright::host::test {
namespace {

void collect(const std::filesystem::path& folder, std::vector<std::filesystem::path>& files) {
  if (!std::filesystem::is_directory(folder)) return;
  for (auto entry = std::filesystem::recursive_directory_iterator(folder); entry != std::filesystem::end(entry);
       ++entry) {
    if (entry->is_directory() && entry->path().filename() == "broken") entry.disable_recursion_pending();
    const std::string ending = lower_ending(entry->path());
    if (entry->is_regular_file() && (ending == ".glb" || ending == ".gltf")) files.push_back(entry->path());
  }
}

}  // namespace

std::vector<std::filesystem::path> own_scenes() {
  std::vector<std::filesystem::path> files;
  collect(CAGEWRIGHT_OWN_SCENES, files);
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<std::filesystem::path> foreign_scenes() {
  std::vector<std::filesystem::path> files;
  std::stringstream folders(CAGEWRIGHT_SCENE_FOLDERS);
  for (std::string folder; std::getline(folders, folder, ':');) collect(folder, files);
  std::sort(files.begin(), files.end());
  return files;
}

Slide::Ellipse some_ellipse(unsigned seed) {
  const double angle = 0.7 * seed, c = std::cos(angle), s = std::sin(angle);
  return {{0.1 * seed, -0.2, 0.3 / (1 + seed)}, {0.5 * c, 0.5 * s, 0}, {-0.2 * s * 0.6, 0.2 * c * 0.6, 0.2 * 0.8}};
}

SceneCage some_cage(int mesh_node, const std::vector<std::int64_t>& slides, unsigned seed) {
  SceneCage cage;
  cage.name = "cage of " + std::to_string(mesh_node);
  cage.mesh_node = mesh_node;
  const double size = 1 + 0.1 * seed;
  cage.mesh.points = {0, 0, 0, size, 0, 0, 0, size, 0, 0, 0, size};
  cage.mesh.triangles = {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3};
  cage.parameters = {{"orient.lambda", 4}, {"refine.delta", 0.1}};
  cage.slides = slides;
  cage.sections = {slides.empty() ? -1 : 0, -1, -1, static_cast<int>(slides.size()) - 1};
  cage.certificate = R"({"closed":true,"encloses":null})";
  return cage;
}

void add_slides_and_cages(SceneDocument& document) {
  CommandStack stack(document);
  unsigned seed = 1;
  for (const SceneMeshNode& node : document.mesh_nodes()) {
    std::vector<std::int64_t> ids;
    for (const char* name : {"new knee", "new \xc3\xa9lbow"}) {
      auto add = std::make_unique<AddSlide>(node.node, name, some_ellipse(seed++),
                                            std::vector<Point3>{{0, 0, 0.1}, {1, 0, 0}, {0, 1, 0}});
      const AddSlide& added = *add;
      stack.run(std::move(add));
      ids.push_back(added.id());
    }
    stack.run(std::make_unique<SetCage>(some_cage(node.node, ids, seed)));
  }
}

void remove_all_of_ours(SceneDocument& document) {
  CommandStack stack(document);
  while (!document.slides().empty()) stack.run(std::make_unique<RemoveSlide>(document.slides().front().id));
  while (!document.cages().empty()) stack.run(std::make_unique<RemoveCage>(document.cages().front().mesh_node));
}

std::string json_text(const std::filesystem::path& path, const std::string& bytes) {
  return std::string(split_gltf(path, bytes).json);
}

std::string chunks(const std::filesystem::path& path, const std::string& bytes) {
  return std::string(split_gltf(path, bytes).chunks);
}

}  // namespace cagewright::host::test
