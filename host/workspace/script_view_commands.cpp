// SPDX-License-Identifier: BSD-3-Clause
//
// Commands that a view carries out; here their arguments are checked.
#include "host/workspace/script_command.h"

namespace cagewright::host {
namespace {

using Kind = ScriptArgument::Kind;

ScriptJson frame(ScriptContext& context, const ScriptArguments& arguments) {
  const std::string what = arguments.choice("what", {"all", "model", "selection", "slide"}, "all");
  if ((what == "slide") != arguments.has("slide")) arguments.fail("\"slide\" names the slide where \"what\" is slide");
  if (what == "slide") static_cast<void>(context.slide(arguments.text("slide")));
  return {};
}

ScriptJson look(ScriptContext&, const ScriptArguments& arguments) {
  arguments.choice("axis", {"front", "back", "left", "right", "top", "bottom", "perspective"}, "");
  return {};
}

ScriptJson up(ScriptContext&, const ScriptArguments& arguments) {
  arguments.choice("axis", {"y", "z"}, "");
  return {};
}

ScriptJson projection(ScriptContext&, const ScriptArguments&) { return {}; }

ScriptJson show(ScriptContext&, const ScriptArguments& arguments) {
  arguments.choice(
      "what", {"model", "other_meshes", "slides", "sections", "cage", "cage_faces", "grid", "wireframe", "speed"}, "");
  return {};
}

ScriptJson colours(ScriptContext&, const ScriptArguments& arguments) {
  arguments.choice("by", {"plain", "parts", "coverage"}, "");
  return {};
}

}  // namespace

std::vector<ScriptCommand> script_view_commands() {
  return {
      {"frame",
       {{"what", Kind::text}, {"slide", Kind::text}},
       "Moves the camera so that \"all\" (else), the \"model\" alone, the \"selection\" or one \"slide\" fills the "
       "view",
       frame,
       true},
      {"look",
       {{"axis", Kind::text, true}},
       "Looks from the front, back, left, right, top or bottom, or as at first: perspective",
       look,
       true},
      {"up", {{"axis", Kind::text, true}}, "Takes y (as at first) or z for up, of the grid and the camera", up, true},
      {"projection", {{"orthographic", Kind::boolean, true}}, "Orthographic, or else perspective", projection, true},
      {"show",
       {{"what", Kind::text, true}, {"on", Kind::boolean, true}},
       "Shows or hides model, other_meshes (those that are not caged), slides, sections, cage, cage_faces, grid, "
       "wireframe or speed",
       show,
       true},
      {"colours", {{"by", Kind::text, true}}, "Colours the model plain, by parts or by coverage", colours, true},
  };
}

}  // namespace cagewright::host
