// SPDX-License-Identifier: BSD-3-Clause
#include "host/workspace/script.h"

#include <algorithm>

#include "host/file/file_error.h"
#include "host/file/strict_json.h"
#include "host/workspace/script_command.h"

namespace cagewright::host {
namespace {

const std::vector<ScriptCommand>& table() {
  static const std::vector<ScriptCommand> commands = [] {
    std::vector<ScriptCommand> all;
    for (const auto& some : {script_file_commands(), script_slide_commands(), script_edit_commands(),
                             script_cage_commands(), script_picture_commands(), script_view_commands()}) {
      all.insert(all.end(), some.begin(), some.end());
    }
    return all;
  }();
  return commands;
}

// Null: there is none of that name.
const ScriptCommand* look_up(const std::string& name) {
  const auto found = std::ranges::find(table(), name, [](const ScriptCommand& it) { return std::string(it.name); });
  return found == table().end() ? nullptr : &*found;
}

const ScriptCommand& find_command(const ScriptJson& command) {
  if (!command.is_object()) throw ScriptError("a command is an object, {\"command\": \"open\", ...}");
  const auto name = command.find("command");
  if (name == command.end() || !name->is_string()) {
    throw ScriptError("a command needs its name, \"command\": \"open\"");
  }
  const ScriptCommand* found = look_up(name->get<std::string>());
  if (found == nullptr) throw ScriptError("there is no command " + in_quotes(name->get<std::string>()));
  return *found;
}

}  // namespace

bool is_blank_script_line(const std::string& line) {
  const std::size_t first = line.find_first_not_of(" \t\r");
  return first == std::string::npos || line[first] == '#';
}

// Who runs it knows the line's file and number; that it is line 1 of itself is not for people.
nlohmann::json parse_script_line(const std::string& line) {
  try {
    return parse_strict_json("", line);
  } catch (const FileError& error) {
    const auto* at = std::get_if<Line>(&error.place());
    throw ScriptError((at && at->column > 0 ? "column " + std::to_string(at->column) + ": " : "") + error.reason());
  }
}

const SceneSlide& ScriptContext::slide(const std::string& name) const {
  const SceneSlide* slide = workspace.find_slide(name);
  if (slide == nullptr) throw CommandError("there is no slide " + in_quotes(name) + " of this mesh");
  return *slide;
}

std::vector<std::int64_t> ScriptContext::slides(const ScriptArguments& arguments, const char* name) const {
  std::vector<std::int64_t> ids;
  for (const std::string& slide_name : arguments.names(name)) {
    const std::int64_t id = slide(slide_name).id;
    if (std::ranges::find(ids, id) != ids.end()) arguments.fail("names " + in_quotes(slide_name) + " twice");
    ids.push_back(id);
  }
  if (ids.empty()) arguments.fail("needs one slide at least");
  return ids;
}

ScriptJson ScriptContext::names_of(const std::vector<std::int64_t>& ids) const {
  ScriptJson names = ScriptJson::array();
  for (const std::int64_t id : ids) names.push_back(workspace.document().find_slide(id)->name);
  return {{"slides", std::move(names)}};
}

ScriptRunner::ScriptRunner(Workspace& workspace, ViewCommand view) : workspace_(workspace), view_(std::move(view)) {}

// While it is there, that command is being run.
class ScriptRunner::Running {
 public:
  Running(std::string& name, const std::string& command) : name_(name) { name_ = command; }
  ~Running() { name_.clear(); }
  Running(const Running&) = delete;
  Running& operator=(const Running&) = delete;

 private:
  std::string& name_;
};

nlohmann::json ScriptRunner::run(const nlohmann::json& command) {
  const ScriptCommand& found = find_command(command);
  const ScriptArguments arguments(command, found.name, found.arguments);
  if (!running_.empty())
    throw ScriptError(std::string(found.name) + ": " + running_ + " is still being run: wait for it, or cancel it");
  const Running running(running_, found.name);
  ScriptContext context{workspace_, clipboard_, is_interrupted_};
  ScriptJson said = found.run(context, arguments);
  if (found.is_of_view && view_) view_(command);
  if (recorder_) recorder_(command);
  return said.is_null() ? ScriptJson::object() : said;
}

bool ScriptRunner::waits_for_cage(const nlohmann::json& command) {
  const bool is_named = command.is_object() && command.contains("command") && command["command"].is_string();
  const ScriptCommand* found = is_named ? look_up(command["command"].get<std::string>()) : nullptr;
  return found != nullptr && found->waits_for_cage;
}

void ScriptRunner::interrupt_where(std::function<bool()> is_interrupted) {
  is_interrupted_ = std::move(is_interrupted);
}

void ScriptRunner::record(std::function<void(const nlohmann::json&)> recorder) { recorder_ = std::move(recorder); }

std::vector<ScriptRunner::Description> ScriptRunner::commands() {
  std::vector<Description> descriptions;
  for (const ScriptCommand& command : table()) {
    std::string arguments;
    for (const ScriptArgument& argument : command.arguments) {
      arguments += (arguments.empty() ? "" : "; ") + std::string(argument.name) + (argument.is_needed ? "" : "?") +
                   ": " + script_kind_text(argument.kind);
    }
    descriptions.push_back({command.name, arguments, command.doc, command.is_of_view});
  }
  return descriptions;
}

}  // namespace cagewright::host
