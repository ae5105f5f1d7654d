// SPDX-License-Identifier: BSD-3-Clause
#include "host/cli/scene_output.h"

#include <algorithm>
#include <memory>

#include "host/cli/input_error.h"
#include "host/command/cage_commands.h"
#include "host/command/command_stack.h"
#include "host/command/slide_commands.h"
#include "host/file/file_bytes.h"
#include "host/file/file_error.h"
#include "host/file/gltf_json.h"
#include "host/scene/external_files.h"
#include "host/scene/mesh_fingerprint.h"

namespace cagewright::host {
namespace {

void remove_slides(CommandStack& stack, const SceneDocument& scene, int node) {
  std::vector<std::int64_t> ids;
  for (const SceneSlide& slide : scene.slides()) {
    if (slide.mesh_node == node) ids.push_back(slide.id);
  }
  for (const std::int64_t id : ids) stack.run(std::make_unique<RemoveSlide>(id));
}

void add_slides(CommandStack& stack, const CageTarget& target, const Session& session, int node) {
  const std::vector<SlideInfo> infos = session.slides();
  for (std::size_t k = 0; k < infos.size(); ++k) {
    const cgw_slide_info& info = infos[k].info;
    const Slide::Ellipse ellipse{std::to_array(info.center), std::to_array(info.u), std::to_array(info.v)};
    const auto* stroke = std::get_if<Slide::Stroke>(&target.slides[k].shape);
    stack.run(
        std::make_unique<AddSlide>(node, infos[k].name, ellipse, stroke ? stroke->points : std::vector<Point3>()));
  }
}

std::string name_for_cage(const SceneDocument& scene, int node) {
  const auto& nodes = scene.mesh_nodes();
  const auto it = std::find_if(nodes.begin(), nodes.end(), [&](const SceneMeshNode& n) { return n.node == node; });
  return it == nodes.end() || it->name.empty() ? "cage" : it->name + " cage";
}

bool is_in_floats(const TriangleMesh& mesh) {
  return std::all_of(mesh.points.begin(), mesh.points.end(),
                     [](double value) { return value == static_cast<double>(static_cast<float>(value)); });
}

// With what it is of, so that nobody believes it of another cage or model. Empty where the scene rounds the cage.
std::string certificate_of(const SceneDocument& scene, int node, const SolvedCage& solved) {
  if (!is_in_floats(solved.cage)) return "";
  GltfJson certificate = parse_gltf_json({}, certificate_text(solved.report.certificate));
  certificate["of"] = {{"model", mesh_fingerprint(scene.mesh(node).mesh)}, {"cage", mesh_fingerprint(solved.cage)}};
  return gltf_json_text(certificate);
}

SceneCage scene_cage(const SceneDocument& scene, const SolvedCage& solved, const Plugin& plugin, int node) {
  SceneCage cage;
  cage.mesh_node = node;
  if (scene.find_cage(node) == nullptr) cage.name = name_for_cage(scene, node);
  cage.mesh = solved.cage;
  for (const Parameter& parameter : plugin.parameters()) {
    cage.parameters.emplace_back(parameter.id, solved.session->parameter(parameter.id));
  }
  for (const SceneSlide& slide : scene.slides()) {  // in the session's order
    if (slide.mesh_node == node) cage.slides.push_back(slide.id);
  }
  cage.sections = solved.session->vertex_sections();
  cage.certificate = certificate_of(scene, node, solved);
  return cage;
}

}  // namespace

std::vector<OutputFile> scene_files(const SceneDocument& scene, const std::filesystem::path& out) {
  std::vector<OutputFile> files = external_copies(scene, out);
  files.emplace_back(out, scene.bytes());
  return files;
}

std::vector<OutputFile> scene_files(const CageInput& input, const std::vector<SolvedCage>& solved, const Plugin& plugin,
                                    const std::filesystem::path& out) {
  const CageTarget& first = input.targets.front();
  SceneDocument scene = input.scene ? input.scene->copy_as(is_binary_scene_name(out))
                                    : SceneDocument::of_mesh(out, first.model, out.stem().string());
  CommandStack stack(scene);
  try {
    for (std::size_t k = 0; k < solved.size(); ++k) {
      const int node = input.scene ? input.targets[k].node : scene.mesh_nodes().front().node;
      if (!input.slides_from_scene) {
        remove_slides(stack, scene, node);
        add_slides(stack, input.targets[k], *solved[k].session, node);
      }
      stack.run(std::make_unique<SetCage>(scene_cage(scene, solved[k], plugin, node)));
    }
  } catch (const CommandError& error) {
    throw InputError(out.string() + ": " + error.what());
  }
  return scene_files(scene, out);
}

}  // namespace cagewright::host
