// SPDX-License-Identifier: BSD-3-Clause
//
// Changes of slides, clipboard, parameters, undo, selection.
#include <algorithm>
#include <numbers>

#include "host/file/atomic_file.h"
#include "host/file/file_bytes.h"
#include "host/file/file_error.h"
#include "host/workspace/script_command.h"
#include "host/workspace/slide_geometry.h"

namespace cagewright::host {
namespace {

using Kind = ScriptArgument::Kind;

Point3 axis_of(const Slide::Ellipse& ellipse, const ScriptArguments& arguments) {
  if (!arguments["axis"].is_string()) return arguments.point("axis");
  const std::string axis = arguments.choice("axis", {"u", "v", "normal"}, "");
  return axis == "u" ? ellipse.u : axis == "v" ? ellipse.v : normal_of(ellipse);
}

// First scaled, then turned, then moved.
Slide::Ellipse changed(Slide::Ellipse ellipse, const ScriptArguments& arguments) {
  for (const auto& [key, part] : {std::pair{"center", &ellipse.center}, {"u", &ellipse.u}, {"v", &ellipse.v}}) {
    if (arguments.has(key)) *part = arguments.point(key);
  }
  if (arguments.has("scale")) {
    const ScriptJson& scale = arguments["scale"];
    const double u = scale.is_array() ? scale[0].get<double>() : scale.get<double>();
    ellipse = scaled(ellipse, u, scale.is_array() ? scale[1].get<double>() : u);
  }
  if (arguments.has("turn")) {
    const double angle = arguments.number("turn", 0) * std::numbers::pi / 180;
    ellipse = turned(ellipse, axis_of(ellipse, arguments), angle);
  }
  return arguments.has("move") ? moved(ellipse, arguments.point("move")) : ellipse;
}

ScriptJson change_slide(ScriptContext& context, const ScriptArguments& arguments) {
  const std::vector<std::int64_t> ids = context.slides(arguments, "slide");
  const auto any = [&](std::initializer_list<const char*> names) {
    return std::any_of(names.begin(), names.end(), [&](const char* name) { return arguments.has(name); });
  };
  if (!any({"center", "u", "v", "move", "turn", "scale"})) {
    arguments.fail("needs \"center\", \"u\", \"v\", \"move\", \"turn\" or \"scale\"");
  }
  if (ids.size() > 1 && any({"center", "u", "v"})) arguments.fail("\"center\", \"u\" and \"v\" are of one slide only");
  if (arguments.has("turn") != arguments.has("axis")) arguments.fail("\"turn\" and \"axis\" need each other");
  std::vector<std::pair<std::int64_t, Slide::Ellipse>> slides;
  for (const std::int64_t id : ids) {
    slides.emplace_back(id, changed(context.workspace.document().find_slide(id)->ellipse, arguments));
  }
  context.workspace.change_slides(slides, arguments.text("label", "change " + counted(ids.size(), "slide")));
  return {};
}

ScriptJson change_slides(ScriptContext& context, const ScriptArguments& arguments) {
  const ScriptJson file = {{"version", 1}, {"slides", arguments["slides"]}};
  std::vector<std::pair<std::int64_t, Slide::Ellipse>> slides;
  for (const Slide& slide : parse_slides("change_slides", file.dump())) {
    const auto* ellipse = std::get_if<Slide::Ellipse>(&slide.shape);
    if (ellipse == nullptr) arguments.fail("slide " + in_quotes(slide.name) + " needs \"center\", \"u\" and \"v\"");
    slides.emplace_back(context.slide(slide.name).id, *ellipse);
  }
  context.workspace.change_slides(slides, arguments.text("label", "change " + counted(slides.size(), "slide")));
  return {};
}

ScriptJson copy_slides(ScriptContext& context, const ScriptArguments& arguments) {
  std::string text = context.workspace.copy_slides(context.slides(arguments));
  if (arguments.has("path")) write_atomically(arguments.text("path"), text);
  context.clipboard = std::move(text);
  return ScriptJson::parse(context.clipboard);
}

ScriptJson paste_slides(ScriptContext& context, const ScriptArguments& arguments) {
  if (arguments.has("path") && arguments.has("slides")) arguments.fail("takes \"path\" or \"slides\", not both");
  std::string text = context.clipboard;
  if (arguments.has("path")) text = read_bytes(arguments.text("path"));
  if (arguments.has("slides")) text = ScriptJson{{"version", 1}, {"slides", arguments["slides"]}}.dump();
  if (text.empty()) throw CommandError("nothing has been copied: copy slides first");
  return context.names_of(context.workspace.paste_slides(text));
}

// A choice by its name, the rest as numbers.
double value_of(const Parameter& parameter, const ScriptArguments& arguments) {
  const ScriptJson& value = arguments["value"];
  if (value.is_boolean()) return value.get<bool>() ? 1 : 0;
  if (value.is_number()) return value.get<double>();
  const auto choice = std::ranges::find(parameter.choices, value.get<std::string>());
  if (choice != parameter.choices.end()) return static_cast<double>(choice - parameter.choices.begin());
  std::string list;
  for (const std::string& it : parameter.choices) list += (list.empty() ? "" : ", ") + it;
  arguments.fail("\"value\" of " + in_quotes(parameter.id) +
                 (list.empty() ? " has to be a number" : " is one of " + list));
}

ScriptJson set_parameter(ScriptContext& context, const ScriptArguments& arguments) {
  const std::string id = arguments.text("id");
  static_cast<void>(context.workspace.parameter(id));  // throws where there is none of that name
  for (const Parameter& parameter : context.workspace.plugin()->parameters()) {
    if (parameter.id == id) context.workspace.set_parameter(id, value_of(parameter, arguments));
  }
  return {};
}

ScriptJson reset_parameters(ScriptContext& context, const ScriptArguments&) {
  context.workspace.reset_parameters();
  return {};
}

ScriptJson undo(ScriptContext& context, const ScriptArguments&) {
  const std::string label = context.workspace.stack().undo_label();
  if (!context.workspace.stack().can_undo()) throw CommandError("there is nothing to undo");
  context.workspace.undo();
  return {{"undone", label}};
}

ScriptJson redo(ScriptContext& context, const ScriptArguments&) {
  const std::string label = context.workspace.stack().redo_label();
  if (!context.workspace.stack().can_redo()) throw CommandError("there is nothing to redo");
  context.workspace.redo();
  return {{"redone", label}};
}

ScriptJson select(ScriptContext& context, const ScriptArguments& arguments) {
  std::vector<std::int64_t> ids;
  for (const std::string& name : arguments.names("slides")) ids.push_back(context.slide(name).id);
  context.workspace.select(std::move(ids));
  return {};
}

}  // namespace

std::vector<ScriptCommand> script_edit_commands() {
  return {
      {"change_slide",
       {{"slide", Kind::names, true},
        {"center", Kind::point},
        {"u", Kind::point},
        {"v", Kind::point},
        {"scale", Kind::factors},
        {"turn", Kind::number},
        {"axis", Kind::axis},
        {"move", Kind::point},
        {"label", Kind::text}},
       "Makes a slide another ellipse, or scales, turns (degrees, about an axis through its centre) and moves slides; "
       "one "
       "step, which undo calls `label`",
       change_slide},
      {"change_slides",
       {{"slides", Kind::objects, true}, {"label", Kind::text}},
       "Makes several slides other ellipses, each {name, center, u, v}, in one step",
       change_slides},
      {"copy_slides",
       {{"slides", Kind::names, true}, {"path", Kind::text}},
       "Keeps slides for paste_slides, and says them as a slides file has them, or writes one",
       copy_slides},
      {"paste_slides",
       {{"slides", Kind::objects}, {"path", Kind::text}},
       "Adds slides as a slides file gives them, or those that were copied; says their names",
       paste_slides},
      {"set_parameter",
       {{"id", Kind::text, true}, {"value", Kind::value, true}},
       "Sets a parameter of the plug-in for the mesh's cage; \"cagewright params\" lists them",
       set_parameter},
      {"reset_parameters", {}, "Sets all parameters to their defaults", reset_parameters},
      {"undo", {}, "Takes back the last step; says which", undo},
      {"redo", {}, "Does again what undo has taken back; says which", redo},
      {"select", {{"slides", Kind::names, true}}, "Selects slides; [] selects none", select},
  };
}

}  // namespace cagewright::host
