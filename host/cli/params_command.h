// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_CLI_PARAMS_COMMAND_H
#define CAGEWRIGHT_HOST_CLI_PARAMS_COMMAND_H

#include "host/cli/command_line.h"

namespace cagewright::host {

// Lists the plug-in's parameters on stdout. Returns exit_done. Throws PluginLoadError and PluginError.
int run_params(const ParamsCommand& command);

}  // namespace cagewright::host

#endif
