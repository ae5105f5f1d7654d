// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_CLI_CAGE_COMMAND_H
#define CAGEWRIGHT_HOST_CLI_CAGE_COMMAND_H

#include "host/cli/command_line.h"

namespace cagewright::host {

// Reads model and slides, has the plug-in make the cage, writes what was asked for, all or nothing, and sums up on
// stdout. Returns exit_done, or exit_not_certified where the cage is not closed (the files are written). Throws
// UsageError, FileError, InputError, PictureError, PluginLoadError, PluginError and Cancelled; then nothing is written.
int run_cage(const CageCommand& command);

}  // namespace cagewright::host

#endif
