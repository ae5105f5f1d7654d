// SPDX-License-Identifier: BSD-3-Clause
#include "host/cli/scene_output.h"

#include <memory>

#include "host/cli/input_error.h"
#include "host/command/cage_commands.h"
#include "host/command/command_stack.h"
#include "host/command/slide_commands.h"
#include "host/file/file_error.h"
#include "host/scene/external_files.h"
#include "host/workspace/scene_cage.h"

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

SceneCage cage_of(const SceneDocument& scene, const SolvedCage& solved, const Plugin& plugin, int node) {
  SceneCage cage = scene_cage(scene, node, solved.cage, &solved.report.certificate);
  for (const Parameter& parameter : plugin.parameters()) {
    cage.parameters.emplace_back(parameter.id, solved.session->parameter(parameter.id));
  }
  for (const SceneSlide& slide : scene.slides()) {  // in the session's order
    if (slide.mesh_node == node) cage.slides.push_back(slide.id);
  }
  cage.sections = solved.session->vertex_sections();
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
      stack.run(std::make_unique<SetCage>(cage_of(scene, solved[k], plugin, node)));
    }
  } catch (const CommandError& error) {
    throw InputError(out.string() + ": " + error.what());
  }
  return scene_files(scene, out);
}

}  // namespace cagewright::host
