// SPDX-License-Identifier: BSD-3-Clause
#include "host/cli/text.h"

#include <algorithm>
#include <array>
#include <charconv>

namespace cagewright::host {

std::string one_line(std::string text) {
  while (!text.empty() && text.back() == '\n') text.pop_back();
  std::replace_if(
      text.begin(), text.end(), [](char c) { return (c >= 0 && c < ' ') || c == 0x7F; }, ' ');
  return text;
}

std::string figure_text(double figure) {
  std::array<char, 32> digits{};
  const auto [end, error] =
      std::to_chars(digits.data(), digits.data() + digits.size(), figure, std::chars_format::general, 6);
  return {digits.data(), end};
}

std::string number_text(double number) {
  std::array<char, 32> digits{};
  const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), number);
  return {digits.data(), end};
}

}  // namespace cagewright::host
