// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_CLI_STRIP_COMMAND_H
#define CAGEWRIGHT_HOST_CLI_STRIP_COMMAND_H

#include "host/cli/command_line.h"

namespace cagewright::host {

// Writes the scene without slides and cages, as it was before they came in, and says on stdout how many there were.
// Returns exit_done. Throws UsageError, FileError, InputError and Cancelled; then nothing is written.
int run_strip(const StripCommand& command);

}  // namespace cagewright::host

#endif
