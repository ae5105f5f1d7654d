// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_CLI_CHECK_COMMAND_H
#define CAGEWRIGHT_HOST_CLI_CHECK_COMMAND_H

#include "host/cli/command_line.h"

namespace cagewright::host {

// Says on stdout what model and cage are as meshes. Returns exit_done where the cage is a closed, consistently oriented
// 2-manifold, else exit_not_certified. Throws FileError, InputError, PluginLoadError and PluginError.
int run_check(const CheckCommand& command);

}  // namespace cagewright::host

#endif
