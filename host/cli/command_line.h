// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_CLI_COMMAND_LINE_H
#define CAGEWRIGHT_HOST_CLI_COMMAND_LINE_H

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "host/view/picture.h"

namespace cagewright::host {

using OptionalPath = std::optional<std::filesystem::path>;

// A parameter of the plug-in and its new value.
struct Setting {
  std::string id, value;
  std::string typed;  // the option as sentences name it: "--delta 2", "--set refine.delta=2"
};

struct CageCommand {
  std::filesystem::path model;
  OptionalPath slides, out, report, picture, plugin;
  std::optional<std::string> node;  // of a scene: a name or a number
  PictureOptions picture_options;   // of one view, which is sound
  // In the order in which they are to be set: --delta, --lambda, --iterations, then every --set.
  std::vector<Setting> settings;
  std::uint32_t threads = 0;  // 0: as many as the machine has
  bool quiet = false;
};

struct CheckCommand {
  std::filesystem::path model, cage;
  OptionalPath report, plugin;
  bool quiet = false;
};

struct ValidateCommand {
  CageCommand cage;  // what is made; its `report` is the validation's, `out` and `picture` are empty
  OptionalPath html;
  std::size_t starts = 200;  // random ones, of the search over equation (1)
  double seconds = 120;      // for the search of a tighter cage; 0: none
};

struct ViewCommand {
  OptionalPath scene, plugin;
  std::optional<std::string> theme;     // "dark" or "light"
  std::optional<std::string> graphics;  // "auto", "card" or "processor"
  bool takes_commands = false;          // from standard input
};

struct StripCommand {
  std::filesystem::path scene, out;
  bool quiet = false;
};

struct ParamsCommand {
  OptionalPath plugin;
  bool as_json = false;
};

// --command FILE: a script.
struct ScriptCommandLine {
  std::filesystem::path script;  // "-": standard input
  OptionalPath plugin;
};

// Help or version was asked for and has been printed.
struct Ended {};

using Invocation = std::variant<CageCommand, CheckCommand, ParamsCommand, StripCommand, ValidateCommand,
                                ScriptCommandLine, ViewCommand, Ended>;

// Reads the command line; help and version go to stdout. Throws UsageError where something is wrong with it.
Invocation parse_command_line(int argc, const char* const* argv);

}  // namespace cagewright::host

#endif
