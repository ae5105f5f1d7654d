// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_CLI_COMMAND_LINE_H
#define CAGEWRIGHT_HOST_CLI_COMMAND_LINE_H

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace cagewright::host {

using OptionalPath = std::optional<std::filesystem::path>;

struct CageCommand {
  std::filesystem::path model;
  OptionalPath slides, out, report, picture, plugin;
  // ID and value in the order in which they are to be set: --delta, --lambda, --iterations, then every --set.
  std::vector<std::pair<std::string, std::string>> parameters;
  std::uint32_t threads = 0;  // 0: as many as the machine has
  bool quiet = false;
};

struct CheckCommand {
  std::filesystem::path model, cage;
  OptionalPath report, plugin;
  bool quiet = false;
};

struct ParamsCommand {
  OptionalPath plugin;
  bool as_json = false;
};

// Nothing is left to do but to end with this code; what there was to say has been said.
struct Ended {
  int exit_code = 0;
};

using Command = std::variant<CageCommand, CheckCommand, ParamsCommand, Ended>;

// Reads the command line; help and version go to stdout, what is wrong with it to stderr (Ended with exit_usage).
Command parse_command_line(int argc, const char* const* argv);

}  // namespace cagewright::host

#endif
