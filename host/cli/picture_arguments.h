// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_CLI_PICTURE_ARGUMENTS_H
#define CAGEWRIGHT_HOST_CLI_PICTURE_ARGUMENTS_H

#include <optional>
#include <string>

#include "host/view/picture.h"

namespace cagewright::host {

// The values of --picture-up, --picture-from and --picture-size as typed.
struct PictureArguments {
  std::optional<std::string> up, from, size;
};

// What they stand for; where only `up` is given, the default view turned with it. Throws UsageError that names the
// option at fault.
PictureOptions to_options(const PictureArguments& arguments);

}  // namespace cagewright::host

#endif
