// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_COMMAND_UTF8_H
#define CAGEWRIGHT_HOST_COMMAND_UTF8_H

#include <string>

namespace cagewright::host {

// Whether a JSON file can hold the text.
bool is_utf8(const std::string& text);

}  // namespace cagewright::host

#endif
