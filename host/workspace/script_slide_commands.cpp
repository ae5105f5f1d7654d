// SPDX-License-Identifier: BSD-3-Clause
#include <numbers>

#include "host/file/file_error.h"
#include "host/workspace/script_command.h"

namespace cagewright::host {
namespace {

using Kind = ScriptArgument::Kind;

// The one way in which the slide is given, by its first key; others of its keys only.
std::string way_of(const ScriptArguments& arguments) {
  static const std::vector<std::vector<const char*>> ways = {
      {"stroke", "line_of_sight", "complete"}, {"point", "normal"}, {"center", "u", "v"}};
  std::string way;
  for (const auto& keys : ways) {
    for (const char* key : keys) {
      if (!arguments.has(key)) continue;
      if (!way.empty() && way != keys.front()) {
        arguments.fail("has both " + in_quotes(way) + " and " + in_quotes(key) + "; a slide is given in one way only");
      }
      if (!arguments.has(keys.front())) arguments.fail(in_quotes(key) + " needs " + in_quotes(keys.front()));
      way = keys.front();
    }
  }
  if (way.empty()) arguments.fail("needs \"stroke\", \"point\", or \"center\", \"u\" and \"v\"");
  return way;
}

ScriptJson add_slide(ScriptContext& context, const ScriptArguments& arguments) {
  Workspace& workspace = context.workspace;
  const std::string way = way_of(arguments);
  const std::string name = arguments.text("name");
  std::int64_t id = -1;
  double tilt = 0;
  if (way == "stroke") {
    const bool is_complete = arguments.flag("complete", arguments.has("line_of_sight"));
    if (is_complete && !arguments.has("line_of_sight")) arguments.fail("\"complete\" needs \"line_of_sight\"");
    const std::vector<Point3> stroke = arguments.points("stroke");
    if (is_complete) {
      const Workspace::SlideAcross added = workspace.add_slide_across(stroke, arguments.point("line_of_sight"), name);
      id = added.id;
      tilt = added.tilt;
    } else {
      id = workspace.add_slide({name, Slide::Stroke{stroke}});
    }
  } else if (way == "point") {
    const Point3 point = arguments.point("point");
    id = arguments.has("normal") ? workspace.add_slide({name, Slide::PointNormal{point, arguments.point("normal")}})
                                 : workspace.add_slide({name, Slide::Point{point}});
  } else {
    if (!arguments.has("u") || !arguments.has("v")) arguments.fail("\"center\" needs \"u\" and \"v\"");
    id = workspace.add_slide(
        {name, Slide::Ellipse{arguments.point("center"), arguments.point("u"), arguments.point("v")}});
  }
  ScriptJson said = {{"slide", workspace.document().find_slide(id)->name}};
  if (tilt > 0) said["tilt"] = tilt * 180 / std::numbers::pi;
  return said;
}

ScriptJson extend_stroke(ScriptContext& context, const ScriptArguments& arguments) {
  context.workspace.extend_stroke(context.slide(arguments.text("slide")).id, arguments.points("points"));
  return {};
}

ScriptJson rename_slide(ScriptContext& context, const ScriptArguments& arguments) {
  context.workspace.rename_slide(context.slide(arguments.text("slide")).id, arguments.text("name"));
  return {};
}

ScriptJson remove_slides(ScriptContext& context, const ScriptArguments& arguments) {
  context.workspace.remove_slides(context.slides(arguments));
  return {};
}

ScriptJson duplicate_slides(ScriptContext& context, const ScriptArguments& arguments) {
  return context.names_of(context.workspace.duplicate_slides(context.slides(arguments)));
}

ScriptJson mirror_slides(ScriptContext& context, const ScriptArguments& arguments) {
  const int axis = arguments.choice("axis", {"x", "y", "z"}, "x")[0] - 'x';
  std::optional<double> at;
  if (arguments.has("at")) at = arguments.number("at", 0);
  return context.names_of(context.workspace.mirror_slides(context.slides(arguments), axis, at));
}

ScriptJson snap_slides(ScriptContext& context, const ScriptArguments& arguments) {
  context.workspace.snap_slides(context.slides(arguments));
  return {};
}

}  // namespace

std::vector<ScriptCommand> script_slide_commands() {
  return {
      {"add_slide",
       {{"name", Kind::text},
        {"stroke", Kind::points},
        {"line_of_sight", Kind::point},
        {"complete", Kind::boolean},
        {"point", Kind::point},
        {"normal", Kind::point},
        {"center", Kind::point},
        {"u", Kind::point},
        {"v", Kind::point}},
       "Adds a slide: of a stroke (with a line of sight: the loop of the plane that holds both; else the ellipse of "
       "the "
       "points alone), of a point (the plane across the limb there, or with that normal), or of an ellipse; says its "
       "name and, where the plane of a stroke was tilted, by how many degrees",
       add_slide},
      {"extend_stroke",
       {{"slide", Kind::text, true}, {"points", Kind::points, true}},
       "Adds points to the stroke that a slide was fitted to, and fits it again",
       extend_stroke},
      {"rename_slide",
       {{"slide", Kind::text, true}, {"name", Kind::text, true}},
       "Gives a slide another name",
       rename_slide},
      {"remove_slides", {{"slides", Kind::names, true}}, "Removes slides, in one step", remove_slides},
      {"duplicate_slides",
       {{"slides", Kind::names, true}},
       "Copies slides a little along their normals, in one step; says the copies' names",
       duplicate_slides},
      {"mirror_slides",
       {{"slides", Kind::names, true}, {"axis", Kind::text}, {"at", Kind::number}},
       "Copies slides to the other side of a plane across the axis \"x\" (else), \"y\" or \"z\", through the middle of "
       "the mesh's box or `at`, in one step; says the copies' names",
       mirror_slides},
      {"snap_slides",
       {{"slides", Kind::names, true}},
       "Makes each slide the ellipse of the loop in its plane, in one step",
       snap_slides},
  };
}

}  // namespace cagewright::host
