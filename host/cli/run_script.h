// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_CLI_RUN_SCRIPT_H
#define CAGEWRIGHT_HOST_CLI_RUN_SCRIPT_H

#include "host/cli/command_line.h"

namespace cagewright::host {

// Runs a script, a command a line, and says on stdout what a command has to say, a line of JSON each. Stops at the
// first that fails; what those before it have written stays. Returns exit_done, or exit_not_certified where the last
// cage that was saved, exported or waited for is not what a cage should be. Throws InputError, which names file and
// line, PictureError, PluginLoadError, PluginError and Cancelled.
int run_script(const ScriptCommandLine& command);

}  // namespace cagewright::host

#endif
