// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_CLI_INPUT_ERROR_H
#define CAGEWRIGHT_HOST_CLI_INPUT_ERROR_H

#include <stdexcept>

namespace cagewright::host {

// What the user gave cannot be used: exit_bad_input. what() names the file or option and says why.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// The command line makes no sense: exit_usage.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace cagewright::host

#endif
