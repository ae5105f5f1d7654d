// SPDX-License-Identifier: BSD-3-Clause
#include "host/view/window/text_wrap.h"

#include <algorithm>
#include <sstream>

namespace cagewright::host {
namespace {

std::size_t characters(const std::string& word) {  // of UTF-8: bytes that do not continue one
  return static_cast<std::size_t>(std::count_if(
      word.begin(), word.end(), [](char byte) { return (static_cast<unsigned char>(byte) & 0xC0) != 0x80; }));
}

std::string wrapped_line(const std::string& line, std::size_t width) {
  std::string text;
  std::size_t used = 0;
  std::istringstream words(line);
  for (std::string word; words >> word;) {
    const std::size_t length = characters(word);
    if (used > 0) {
      const bool fits = used + 1 + length <= width;
      text += fits ? ' ' : '\n';
      used = fits ? used + 1 : 0;
    }
    text += word;
    used += length;
  }
  return text;
}

}  // namespace

std::string wrapped(const std::string& text, std::size_t width) {
  std::string result;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (!result.empty()) result += '\n';
    result += wrapped_line(line, width);
  }
  return result;
}

}  // namespace cagewright::host
