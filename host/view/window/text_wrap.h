// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_VIEW_WINDOW_TEXT_WRAP_H
#define CAGEWRIGHT_HOST_VIEW_WINDOW_TEXT_WRAP_H

#include <cstddef>
#include <string>

namespace cagewright::host {

// UTF-8 text with its line breaks and new ones at spaces, so that no line has more characters than `width` unless one
// word has. Runs of spaces become one.
std::string wrapped(const std::string& text, std::size_t width);

}  // namespace cagewright::host

#endif
