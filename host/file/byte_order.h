// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_FILE_BYTE_ORDER_H
#define CAGEWRIGHT_HOST_FILE_BYTE_ORDER_H

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstring>
#include <string>

namespace cagewright::host {

// The number whose bytes begin at `from`, which need not be aligned, in the file's byte order.
template <class Number>
Number load(const char* from, std::endian order) {
  std::array<char, sizeof(Number)> bytes;
  std::memcpy(bytes.data(), from, bytes.size());
  if (order != std::endian::native) std::reverse(bytes.begin(), bytes.end());
  return std::bit_cast<Number>(bytes);
}

// Appends the number's bytes, least significant first.
template <class Number>
void append_little_endian(std::string& to, Number number) {
  auto bytes = std::bit_cast<std::array<char, sizeof(Number)>>(number);
  if (std::endian::native != std::endian::little) std::reverse(bytes.begin(), bytes.end());
  to.append(bytes.data(), bytes.size());
}

}  // namespace cagewright::host

#endif
