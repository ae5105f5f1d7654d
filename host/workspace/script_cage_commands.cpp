// SPDX-License-Identifier: BSD-3-Clause
#include "host/file/atomic_file.h"
#include "host/file/file_error.h"
#include "host/plugin_client/plugin_error.h"
#include "host/workspace/describe_run.h"
#include "host/workspace/script_command.h"
#include "host/workspace/validate_mesh.h"

namespace cagewright::host {
namespace {

using Kind = ScriptArgument::Kind;

ScriptJson solve(ScriptContext& context, const ScriptArguments&) {
  context.workspace.solve();
  return {};
}

ScriptJson wait(ScriptContext& context, const ScriptArguments&) {
  context.workspace.wait_for_cage();
  const CageState& cage = context.workspace.cage();
  ScriptJson problems = ScriptJson::array();
  for (const Problem& problem : cage.problems) {
    ScriptJson slides = ScriptJson::array();
    for (const std::int64_t id : problem.slides) {
      if (const SceneSlide* slide = context.workspace.document().find_slide(id)) slides.push_back(slide->name);
    }
    problems.push_back({{"sentence", problem.sentence}, {"slides", std::move(slides)}});
    if (problem.place) problems.back()["place"] = *problem.place;
    if (problem.is_advice) problems.back()["is_advice"] = true;
  }
  return {{"cage_triangles", cage.cage.triangle_count()}, {"is_of_now", cage.is_of_now}, {"problems", problems}};
}

ScriptJson cancel(ScriptContext& context, const ScriptArguments&) {
  context.workspace.cancel_solve();
  return {};
}

ScriptJson report(ScriptContext& context, const ScriptArguments& arguments) {
  Workspace& workspace = context.workspace;
  workspace.wait_for_cage();
  const CageState& cage = workspace.cage();
  if (cage.failed || !cage.report) {
    throw CommandError(cage.problems.empty() ? "there is no cage to report on: solve it first"
                                             : "there is no cage to report on: " + cage.problems.front().sentence);
  }
  Report report = *cage.report;
  report.options.insert(report.options.begin(), {"model", workspace.path().string()});
  report.peak_memory_mb = peak_memory_mb();
  const std::string text = report_text(report);
  if (!arguments.has("path")) return ScriptJson::parse(text);
  write_atomically(arguments.text("path"), text);
  return {};
}

ScriptJson validate(ScriptContext& context, const ScriptArguments& arguments) {
  ValidationOptions options;
  options.seconds = arguments.number("seconds", options.seconds);
  if (options.seconds < 0) arguments.fail("\"seconds\" has to be 0 or more");
  if (arguments.has("starts")) options.starts = arguments["starts"].get<std::size_t>();
  const MeshValidation found = validate_mesh(context.workspace, options, context.is_interrupted);
  const std::string json = validation_json(found.report);
  if (arguments.has("html")) write_atomically(arguments.text("html"), validation_page(found));
  if (!arguments.has("json")) return ScriptJson::parse(json);
  write_atomically(arguments.text("json"), json);
  return {{"agrees", found.report.agrees()}};
}

}  // namespace

std::vector<ScriptCommand> script_cage_commands() {
  return {
      {"solve", {}, "Asks for the cage again, in the background; also after cancel", solve},
      {"wait", {}, "Waits for the cage; says what is wrong with it, if anything", wait, false, true},
      {"cancel", {}, "Cancels the solve; the cage is not followed before the next change or solve", cancel},
      {"report",
       {{"path", Kind::text}},
       "Waits for the cage; writes its report or says it, as \"cagewright cage --report\" does",
       report,
       false,
       true},
      {"validate",
       {{"html", Kind::text}, {"json", Kind::text}, {"seconds", Kind::number}, {"starts", Kind::whole}},
       "Has Ceres check the plug-in's figures, as \"cagewright validate\" does, and waits; writes what it finds or "
       "says "
       "it",
       validate,
       false,
       true},
  };
}

}  // namespace cagewright::host
