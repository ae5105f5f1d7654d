// SPDX-License-Identifier: BSD-3-Clause
#include "host/file/file_error.h"
#include "host/workspace/script_command.h"

namespace cagewright::host {
namespace {

using Kind = ScriptArgument::Kind;

ScriptJson open(ScriptContext& context, const ScriptArguments& arguments) {
  context.workspace.open(arguments.text("path"));
  const std::vector<std::string>& notes = context.workspace.notes();
  return notes.empty() ? ScriptJson() : ScriptJson{{"notes", notes}};
}

ScriptJson close(ScriptContext& context, const ScriptArguments&) {
  context.workspace.close();
  return {};
}

ScriptJson save(ScriptContext& context, const ScriptArguments& arguments) {
  if (!context.workspace.has_scene()) throw CommandError("no scene is open: open one first");
  context.workspace.save(arguments.text("path", context.workspace.path().string()));
  return {};
}

ScriptJson save_copy(ScriptContext& context, const ScriptArguments& arguments) {
  context.workspace.save_copy(arguments.text("path"));
  return {};
}

ScriptJson export_cage(ScriptContext& context, const ScriptArguments& arguments) {
  context.workspace.export_cage(arguments.text("path"));
  return {};
}

// By name where one node alone has it, else by number.
ScriptJson select_mesh(ScriptContext& context, const ScriptArguments& arguments) {
  Workspace& workspace = context.workspace;
  const ScriptJson& wanted = arguments["node"];
  int node = -1, count = 0;
  for (const SceneMeshNode& it : workspace.document().mesh_nodes()) {
    const bool is_it =
        wanted.is_string() ? it.name == wanted.get<std::string>() : it.node == wanted.get<std::int64_t>();
    if (!is_it) continue;
    node = it.node;
    ++count;
  }
  if (count != 1) {
    throw CommandError((count == 0 ? "no node" : "more than one node") + std::string(" with a mesh is called ") +
                       wanted.dump() + ": give its number");
  }
  workspace.choose_mesh(node);
  return {};
}

ScriptJson load_plugin(ScriptContext& context, const ScriptArguments& arguments) {
  context.workspace.load_plugin(arguments.text("path"));
  return {};
}

ScriptJson unload_plugin(ScriptContext& context, const ScriptArguments&) {
  context.workspace.unload_plugin();
  return {};
}

}  // namespace

std::vector<ScriptCommand> script_file_commands() {
  return {
      {"open", {{"path", Kind::text, true}}, "Opens a model or scene: .glb .gltf .obj .off .ply .stl", open},
      {"close", {}, "Closes the scene, without saving it", close},
      {"save",
       {{"path", Kind::text}},
       "Waits for the cage and writes the scene with it, .glb or .gltf; without a path, where it was saved last",
       save,
       false,
       true},
      {"save_copy",
       {{"path", Kind::text, true}},
       "Writes the scene with the last good cage; the scene that is open stays as it is",
       save_copy},
      {"export_cage",
       {{"path", Kind::text, true}},
       "Waits for the cage and writes it alone: .obj .off .ply .stl .glb .gltf",
       export_cage,
       false,
       true},
      {"select_mesh", {{"node", Kind::name_or_number, true}}, "Chooses the mesh node that is caged", select_mesh},
      {"load_plugin", {{"path", Kind::text, true}}, "Loads another plug-in in the place of this one", load_plugin},
      {"unload_plugin", {}, "Unloads the plug-in; refused while a scene with slides or a cage is open", unload_plugin},
  };
}

}  // namespace cagewright::host
