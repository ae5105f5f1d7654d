// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_WORKSPACE_SCRIPT_H
#define CAGEWRIGHT_HOST_WORKSPACE_SCRIPT_H

#include <functional>
#include <iosfwd>
#include <nlohmann/json_fwd.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "host/workspace/workspace.h"

namespace cagewright::host {

// A command that is none, or with arguments that are missing, unknown or of the wrong type; what() names both.
class ScriptError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Of a script's text: a line that holds no command, being blank or a comment.
bool is_blank_script_line(const std::string& line);
// Throws ScriptError, which names the column: it is no JSON.
nlohmann::json parse_script_line(const std::string& line);

// Runs commands written as JSON objects, {"command": "add_slide", "point": [x, y, z]}: those of the menus, and those of
// `cagewright --command FILE`. docs/script.md lists them. Slides are named by their names.
class ScriptRunner {
 public:
  // What a view has to do; without one they do nothing but check their arguments.
  using ViewCommand = std::function<void(const nlohmann::json& command)>;

  explicit ScriptRunner(Workspace& workspace, ViewCommand view = {});

  // Returns what the command has to say: {} or, of report, copy ..., an object. Throws ScriptError, CommandError,
  // FileError, PluginError, PluginLoadError, PictureError, Cancelled; then nothing has changed. Called by what
  // interrupt_where asks it throws ScriptError: one command is run at a time.
  nlohmann::json run(const nlohmann::json& command);

  // Whether that command begins with waiting for the cage: then a window may wait before it, and go on meanwhile. False
  // of what is no command.
  static bool waits_for_cage(const nlohmann::json& command);

  // Asked while a command works for long (validate, turntable: before each frame); where it answers true the command
  // throws Cancelled. May be empty.
  void interrupt_where(std::function<bool()> is_interrupted);

  // Called with every command that was run, so that it can be recorded. May be empty.
  void record(std::function<void(const nlohmann::json& command)> recorder);

  // For help and documents: "add_slide", "point: [x, y, z]; ...".
  struct Description {
    std::string name, arguments, doc;
    bool is_of_view = false;
  };
  static std::vector<Description> commands();

 private:
  class Running;

  Workspace& workspace_;
  ViewCommand view_;
  std::function<void(const nlohmann::json&)> recorder_;
  std::function<bool()> is_interrupted_;
  std::string running_;    // the command that is being run; empty: none
  std::string clipboard_;  // of copy_slides, for paste_slides without slides
};

}  // namespace cagewright::host

#endif
