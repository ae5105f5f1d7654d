// SPDX-License-Identifier: BSD-3-Clause
#include <filesystem>

#include "host/file/file_bytes.h"
#include "host/file/file_error.h"
#include "host/plugin_client/plugin_error.h"
#include "host/workspace/scene_picture.h"
#include "host/workspace/script_command.h"

namespace cagewright::host {
namespace {

using Kind = ScriptArgument::Kind;

PictureOptions options_of(const ScriptArguments& arguments) {
  PictureOptions options;
  View& view = options.views.front();
  if (arguments.has("up")) {
    if (arguments.point("up") == Point3{}) arguments.fail("\"up\" gives no direction");
    view = default_view(arguments.point("up"));
  }
  if (arguments.has("from")) view.toward_viewer = arguments.point("from");
  if (!is_sound(view)) arguments.fail("\"from\" has to be a direction that is not parallel to what is up");
  if (arguments.has("size")) {
    for (const std::size_t k : {0, 1}) {
      const auto pixels = arguments["size"][k].get<std::uint64_t>();
      if (pixels < smallest_picture || pixels > largest_picture) {
        arguments.fail("\"size\" has to be from " + std::to_string(smallest_picture) + " to " +
                       std::to_string(largest_picture));
      }
      (k == 0 ? options.width : options.height) = static_cast<int>(pixels);
    }
  }
  return options;
}

ScriptJson picture(ScriptContext& context, const ScriptArguments& arguments) {
  const PictureOptions options = options_of(arguments);
  const std::filesystem::path path = arguments.text("path");
  if (lower_ending(path) != ".png") arguments.fail("a picture is written as .png, not " + in_quotes(path.string()));
  context.workspace.wait_for_cage();
  write_picture(scene_picture(context.workspace), options, path);
  return {};
}

// frame_0001.png and so on.
ScriptJson turn(ScriptContext& context, const ScriptArguments& arguments) {
  constexpr std::uint64_t most = 9999;
  PictureOptions options = options_of(arguments);
  const std::uint64_t frames = arguments.has("frames") ? arguments["frames"].get<std::uint64_t>() : 36;
  if (frames < 1 || frames > most) arguments.fail("\"frames\" has to be from 1 to " + std::to_string(most));
  const std::filesystem::path folder = arguments.text("folder");
  context.workspace.wait_for_cage();
  PictureInput input = scene_picture(context.workspace);
  // Of its own: between the frames a window goes on, and its cage may become another one.
  const TriangleMesh model = context.workspace.mesh(), cage = context.workspace.cage().cage;
  input.model_points = model.points;
  input.model_triangles = model.triangles;
  input.cage_points = cage.points;
  input.cage_triangles = cage.triangles;
  std::error_code error;  // where it cannot be made the first file says so
  std::filesystem::create_directories(folder, error);
  std::uint64_t number = 0;
  for (const View& view : turntable(options.views.front(), frames)) {
    if (context.is_interrupted && context.is_interrupted()) throw Cancelled();
    const std::string digits = std::to_string(++number);
    options.views = {view};
    write_picture(input, options, folder / ("frame_" + std::string(4 - digits.size(), '0') + digits + ".png"));
  }
  return {{"frames", frames}};
}

}  // namespace

std::vector<ScriptCommand> script_picture_commands() {
  return {
      {"picture",
       {{"path", Kind::text, true}, {"from", Kind::point}, {"up", Kind::point}, {"size", Kind::size}},
       "Waits for the cage and writes a picture of mesh, slides and cage, .png; needs a display",
       picture,
       false,
       true},
      {"turntable",
       {{"folder", Kind::text, true},
        {"frames", Kind::whole},
        {"from", Kind::point},
        {"up", Kind::point},
        {"size", Kind::size}},
       "The same as frame_0001.png, frame_0002.png ... (36) of a whole turn; needs a display",
       turn,
       false,
       true},
  };
}

}  // namespace cagewright::host
