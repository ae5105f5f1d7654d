// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_CLI_VALIDATE_COMMAND_H
#define CAGEWRIGHT_HOST_CLI_VALIDATE_COMMAND_H

#include "host/cli/command_line.h"

namespace cagewright::host {

// Makes the scene's cages as `cage` does, has Ceres check the figures that the plug-in hands out, writes the report and
// the page, and sums up on stdout. Returns exit_done where everything agrees, else exit_not_certified (the files are
// written). Throws as run_cage; where there is no display the page says so.
int run_validate(const ValidateCommand& command);

}  // namespace cagewright::host

#endif
