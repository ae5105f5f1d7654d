// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_WORKSPACE_SCRIPT_COMMAND_H
#define CAGEWRIGHT_HOST_WORKSPACE_SCRIPT_COMMAND_H

#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "host/workspace/script.h"

// What the commands of ScriptRunner are made of. Include in .cpp files only.
namespace cagewright::host {

using ScriptJson = nlohmann::json;

struct ScriptArgument {
  enum class Kind {
    text,
    name_or_number,
    names,  // one name, or a list of them
    number,
    whole,
    boolean,
    value,    // a number, true, false or a name
    point,    // [x, y, z]
    points,   // [[x, y, z], ...]
    factors,  // a number, or two in a list
    axis,     // "u", "v", "normal" or [x, y, z]
    size,     // [width, height]
    object,
    objects,
  };
  const char* name;
  Kind kind;
  bool is_needed = false;
};

// The arguments of a command, all of which are what its table says.
class ScriptArguments {
 public:
  // Throws ScriptError, which names command and argument: one that is unknown, missing or of another kind.
  ScriptArguments(const ScriptJson& command, const std::string& name, const std::vector<ScriptArgument>& known);

  bool has(const char* name) const { return command_.contains(name); }
  const ScriptJson& operator[](const char* name) const { return command_.at(name); }
  std::string text(const char* name, const std::string& otherwise = "") const;
  double number(const char* name, double otherwise) const;
  bool flag(const char* name, bool otherwise) const;
  Point3 point(const char* name) const;
  std::vector<Point3> points(const char* name) const;
  std::vector<std::string> names(const char* name) const;
  // One of `choices`. Throws ScriptError.
  std::string choice(const char* name, const std::vector<std::string>& choices, const std::string& otherwise) const;
  [[noreturn]] void fail(const std::string& what) const;

 private:
  const ScriptJson& command_;
  std::string name_;
};

// "[x, y, z]", "true or false" ...
std::string script_kind_text(ScriptArgument::Kind kind);

// What a command works on.
struct ScriptContext {
  Workspace& workspace;
  std::string& clipboard;
  const std::function<bool()>& is_interrupted;

  // Of the mesh that is being caged. Throws CommandError: no slide of that name.
  const SceneSlide& slide(const std::string& name) const;
  std::vector<std::int64_t> slides(const ScriptArguments& arguments, const char* name = "slides") const;
  ScriptJson names_of(const std::vector<std::int64_t>& ids) const;
};

struct ScriptCommand {
  const char* name;
  std::vector<ScriptArgument> arguments;
  const char* doc;
  ScriptJson (*run)(ScriptContext&, const ScriptArguments&);  // of a view: checks its arguments
  bool is_of_view = false;
  bool waits_for_cage = false;
};

// The table, by subject.
std::vector<ScriptCommand> script_file_commands();
std::vector<ScriptCommand> script_slide_commands();
std::vector<ScriptCommand> script_edit_commands();
std::vector<ScriptCommand> script_cage_commands();
std::vector<ScriptCommand> script_picture_commands();
std::vector<ScriptCommand> script_view_commands();

}  // namespace cagewright::host

#endif
