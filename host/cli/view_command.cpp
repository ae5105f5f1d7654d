// SPDX-License-Identifier: BSD-3-Clause
#include "host/cli/view_command.h"

#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <string>
#include <vector>

#include "host/cli/input_error.h"
#include "host/view/picture.h"

namespace cagewright::host {

int run_view(const ViewCommand& command) {
  require_display();
  const std::filesystem::path window =
      std::filesystem::read_symlink("/proc/self/exe").parent_path() / "cagewright_window";
  std::vector<std::string> arguments = {window.string()};
  if (command.scene) arguments.push_back(command.scene->string());
  if (command.plugin) arguments.insert(arguments.end(), {"--plugin", command.plugin->string()});
  if (command.theme) arguments.insert(arguments.end(), {"--theme", *command.theme});
  if (command.graphics) arguments.insert(arguments.end(), {"--graphics", *command.graphics});
  if (command.takes_commands) arguments.emplace_back("--commands");
  std::vector<char*> raw;
  for (std::string& argument : arguments) raw.push_back(argument.data());
  raw.push_back(nullptr);
  // What main set would stay over exec.
  for (const int signal : {SIGPIPE, SIGXFSZ}) std::signal(signal, SIG_DFL);
  execv(window.c_str(), raw.data());
  throw InputError(window.string() + ": the window cannot be started (" + std::strerror(errno) +
                   "): install it beside this program");
}

}  // namespace cagewright::host
