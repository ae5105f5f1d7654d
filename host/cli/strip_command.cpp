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

namespace cagewright::host {

int run_strip(const StripCommand& command) {
  for (const auto& [path, what] : {std::pair(&command.scene, ""), std::pair(&command.out, "-o ")}) {
    if (!is_scene_name(*path)) throw UsageError(what + path->string() + ": a scene is a .glb or .gltf");
  }
  require_writable(command.out);
  SceneDocument scene(command.scene);
  Progress progress(command.quiet);
  for (const std::string& note : scene.notes()) progress.note(note);
  const std::size_t slides = scene.slides().size(), cages = scene.cages().size();
  CommandStack stack(scene);
  while (!scene.slides().empty()) stack.run(std::make_unique<RemoveSlide>(scene.slides().front().id));
  while (!scene.cages().empty()) stack.run(std::make_unique<RemoveCage>(scene.cages().front().mesh_node));
  const SceneDocument stripped = scene.copy_as(is_binary_scene_name(command.out));
  write_files(scene_files(stripped, command.out), [&] {
    std::cout << "taken out: " << counted(slides, "slide") << ", " << counted(cages, "cage") << "\n";
  });
  return exit_done;
}

}  // namespace cagewright::host
