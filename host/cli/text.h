// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_CLI_TEXT_H
#define CAGEWRIGHT_HOST_CLI_TEXT_H

#include <string>

namespace cagewright::host {

// `text` without control characters, so that it stays one line whatever names a file holds.
std::string one_line(std::string text);

// For people: 6 significant digits.
std::string figure_text(double figure);

// The shortest decimal number that reads back as the same double; "inf" and "nan" as such.
std::string number_text(double number);

}  // namespace cagewright::host

#endif
