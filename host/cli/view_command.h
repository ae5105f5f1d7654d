// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_CLI_VIEW_COMMAND_H
#define CAGEWRIGHT_HOST_CLI_VIEW_COMMAND_H

#include "host/cli/command_line.h"

namespace cagewright::host {

// Becomes the window, `cagewright_window` beside this program: returns only where there is none. Throws InputError.
int run_view(const ViewCommand& command);

}  // namespace cagewright::host

#endif
