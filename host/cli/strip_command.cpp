// SPDX-License-Identifier: BSD-3-Clause
#include "host/cli/strip_command.h"

#include <iostream>
#include <memory>

#include "host/cli/exit_code.h"
#include "host/cli/input_error.h"
#include "host/cli/output_files.h"
#include "host/cli/progress.h"
#include "host/cli/scene_output.h"
#include "host/command/cage_commands.h"
#include "host/command/command_stack.h"
#include "host/command/slide_commands.h"
#include "host/file/atomic_file.h"
#include "host/file/file_error.h"
#include "host/scene/external_files.h"

namespace cagewright::host {

int run_strip(const StripCommand& command) {
  for (const auto& [path, what] : {std::pair(&command.scene, ""), std::pair(&command.out, "-o ")}) {
    if (!is_scene_name(*path)) throw UsageError(what + path->string() + ": a scene is a .glb or .gltf");
  }
  require_writable(command.out);
  const bool is_binary = is_binary_scene_name(command.out);
  SceneDocument scene(command.scene, SceneDocument::Unreadable::stray);
  Progress progress(command.quiet);
  for (const std::string& note : scene.lost_as(is_binary)) progress.note(note);
  for (const std::string& note : missed_files(scene, command.out)) progress.note(note);
  std::size_t slides = scene.slides().size(), cages = scene.cages().size();
  for (const SceneStray& stray : scene.strays()) ++(stray.is_cage ? cages : slides);
  CommandStack stack(scene);
  while (!scene.slides().empty()) stack.run(std::make_unique<RemoveSlide>(scene.slides().back().id));
  while (!scene.cages().empty()) stack.run(std::make_unique<RemoveCage>(scene.cages().back().mesh_node));
  while (!scene.strays().empty()) stack.run(std::make_unique<RemoveStray>(scene.strays().size() - 1));
  const SceneDocument stripped = scene.copy_as(is_binary);
  write_files(scene_files(stripped, command.out), [&] {
    std::cout << "taken out: " << counted(slides, "slide") << ", " << counted(cages, "cage") << "\n";
  });
  return exit_done;
}

}  // namespace cagewright::host
