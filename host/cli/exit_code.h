// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_CLI_EXIT_CODE_H
#define CAGEWRIGHT_HOST_CLI_EXIT_CODE_H

namespace cagewright::host {

// Other programs rely on these.
enum ExitCode : int {
  exit_done = 0,
  exit_not_certified = 1,  // done and written, but the cage is not what a cage should be
  exit_usage = 2,
  exit_bad_input = 3,  // one line on stderr says which file, where and why
  exit_internal = 4,
  exit_cancelled = 130,  // nothing was written
};

}  // namespace cagewright::host

#endif
