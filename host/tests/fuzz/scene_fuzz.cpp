// SPDX-License-Identifier: BSD-3-Clause
//
// Any bytes as a scene: they are refused with a FileError, or they are read, get slides and cages by commands, and come
// back the same from what is saved.
#include <algorithm>
#include <cmath>

#include "host/command/cage_commands.h"
#include "host/command/command_stack.h"
#include "host/command/slide_commands.h"
#include "host/file/file_error.h"
#include "host/file/mesh_reader.h"
#include "host/scene/external_files.h"
#include "host/tests/fuzz/fuzz_target.h"

namespace cagewright::host {
namespace {

constexpr std::size_t most_nodes = 4;  // that get slides and a cage, so that a long file does not take long

// A .gltf may name the buffers of our own scenes, whatever a file does with them.
std::filesystem::path path_of(std::string_view bytes) {
  return std::filesystem::path(CAGEWRIGHT_OWN_SCENES) / (bytes.starts_with("glTF") ? "fuzz.glb" : "fuzz.gltf");
}

void read_meshes(const SceneDocument& document) {
  for (const SceneMeshNode& node : document.mesh_nodes()) {
    try {
      static_cast<void>(document.mesh(node.node));
    } catch (const FileError&) {  // no triangles, positions that are not finite
    }
  }
}

void read_whole(const std::filesystem::path& path, std::string_view bytes) {
  for (const MeshRole role : {MeshRole::model, MeshRole::cage}) {
    try {
      static_cast<void>(read_gltf(path, bytes, role));
    } catch (const FileError&) {
    }
  }
}

// Commands may refuse, but only with their own error.
void run(CommandStack& stack, std::unique_ptr<Command> command) {
  try {
    stack.run(std::move(command));
  } catch (const CommandError&) {
  }
}

SceneCage some_cage(int node, const SceneDocument& document) {
  SceneCage cage;
  cage.name = "cage";
  cage.mesh_node = node;
  cage.mesh.points = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
  cage.mesh.triangles = {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3};
  cage.parameters = {{"orient.lambda", 4}};
  for (const SceneSlide& slide : document.slides()) {
    if (slide.mesh_node == node) cage.slides.push_back(slide.id);
  }
  cage.sections = {-1, cage.slides.empty() ? -1 : 0, -1, -1};
  cage.certificate = R"({"closed": true})";
  return cage;
}

void edit(SceneDocument& document, CommandStack& stack) {
  const Slide::Ellipse ellipse = {{0.1, 0.2, 0.3}, {0.5, 0, 0}, {0, 0.25, 0.125}};
  std::vector<std::int64_t> ids;
  for (const SceneSlide& slide : document.slides()) ids.push_back(slide.id);
  for (std::size_t k = 0; k < ids.size() && k < most_nodes; ++k) {
    if (k % 4 == 0) run(stack, std::make_unique<RenameSlide>(ids[k], "renamed"));
    if (k % 4 == 1) run(stack, std::make_unique<ChangeSlide>(ids[k], ellipse));
    if (k % 4 == 2) run(stack, std::make_unique<RemoveSlide>(ids[k]));
  }
  const std::vector<SceneMeshNode> nodes = document.mesh_nodes();
  for (std::size_t k = 0; k < nodes.size() && k < most_nodes; ++k) {
    const int node = nodes[k].node;
    run(stack, std::make_unique<AddSlide>(node, "knee", ellipse, std::vector<Point3>{{1, 2, 3}, {4, 5, 6}}));
    run(stack, std::make_unique<SetCage>(some_cage(node, document)));
  }
}

void remove_all(SceneDocument& document) {
  CommandStack stack(document);
  while (!document.slides().empty()) stack.run(std::make_unique<RemoveSlide>(document.slides().front().id));
  while (!document.cages().empty()) stack.run(std::make_unique<RemoveCage>(document.cages().front().mesh_node));
}

// But for rounding, where nodes above it shear and scale.
bool is_same(const Slide::Ellipse& a, const Slide::Ellipse& b) {
  double size = 0, difference = 0;
  for (const auto member : {&Slide::Ellipse::center, &Slide::Ellipse::u, &Slide::Ellipse::v}) {
    for (std::size_t i = 0; i < 3; ++i) {
      size = std::max(size, std::abs((a.*member)[i]));
      difference = std::max(difference, std::abs((a.*member)[i] - (b.*member)[i]));
    }
  }
  return difference <= 1e-6 * size;
}

void require_same(const SceneDocument& a, const SceneDocument& b) {
  require(a.mesh_nodes().size() == b.mesh_nodes().size(), "a mesh node is gone or new");
  require(a.slides().size() == b.slides().size(), "a slide is gone or new");
  require(a.cages().size() == b.cages().size(), "a cage is gone or new");
  for (const SceneSlide& slide : a.slides()) {
    const SceneSlide* other = b.find_slide(slide.id);
    require(other && other->name == slide.name && other->mesh_node == slide.mesh_node, "a slide is another one");
    require(is_same(slide.ellipse, other->ellipse), "a slide is elsewhere");
    require(slide.stroke == other->stroke, "a slide's stroke is another one");
  }
  for (const SceneCage& cage : a.cages()) {
    const SceneCage* other = b.find_cage(cage.mesh_node);
    require(other && other->slides == cage.slides && other->sections == cage.sections, "a cage is another one");
    require(other->mesh.triangles == cage.mesh.triangles, "a cage has other triangles");
  }
}

void check(const std::filesystem::path& path, const std::string& bytes) {
  SceneDocument document(path, bytes);  // from here on nothing may be refused
  read_meshes(document);
  require_no_throw("saving and loading", [&] {
    require(document.bytes() == bytes, "what was only read is saved as other bytes");
    CommandStack stack(document);
    edit(document, stack);
    const std::string saved = document.bytes();
    SceneDocument again(path, saved);
    require(again.bytes() == saved, "what was saved and read is saved as other bytes");
    require_same(document, again);
    static_cast<void>(external_copies(document, "/nowhere/else.gltf"));
    const SceneDocument other = again.copy_as(!bytes.starts_with("glTF"));
    require_same(again, other);
    require(SceneDocument(other.path(), other.bytes()).bytes() == other.bytes(), "the copy is saved as other bytes");
    while (stack.undo()) {
    }
    require(document.bytes() == bytes, "undoing everything leads to other bytes");
    remove_all(again);
    const SceneDocument stripped(path, again.bytes());
    require(stripped.slides().empty() && stripped.cages().empty(), "what was removed is there again");
  });
}

}  // namespace
}  // namespace cagewright::host

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace cagewright::host;
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  const std::filesystem::path path = path_of(bytes);
  read_whole(path, bytes);
  try {
    check(path, bytes);
  } catch (const FileError&) {
  }
  return 0;
}
