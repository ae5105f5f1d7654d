// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <bit>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

// Little-endian bytes, whatever the machine is.
namespace cagewright::plugin {

using Bytes = std::vector<unsigned char>;

class ByteWriter {
 public:
  template <class Unsigned>
  void number(Unsigned value) {
    static_assert(std::is_unsigned_v<Unsigned>);
    for (std::size_t k = 0; k < sizeof value; ++k) bytes_.push_back(static_cast<unsigned char>(value >> (8 * k)));
  }
  void real(double value) { number(std::bit_cast<std::uint64_t>(value)); }
  // A 32-bit length, then the characters. Throws std::length_error from 4 GB on.
  void text(std::string_view value) {
    if (value.size() > UINT32_MAX) throw std::length_error("a text of 4 GB or more cannot be saved");
    number(static_cast<std::uint32_t>(value.size()));
    bytes_.insert(bytes_.end(), value.begin(), value.end());
  }
  void append(const Bytes& bytes) { bytes_.insert(bytes_.end(), bytes.begin(), bytes.end()); }

  const Bytes& bytes() const { return bytes_; }

 private:
  Bytes bytes_;
};

// Where bytes end too early.
struct OutOfBytes {};

class ByteReader {
 public:
  explicit ByteReader(std::span<const unsigned char> bytes) : bytes_(bytes) {}

  // All throw OutOfBytes, before anything is allocated.
  template <class Unsigned>
  Unsigned number() {
    static_assert(std::is_unsigned_v<Unsigned>);
    Unsigned value = 0;
    const auto from = take(sizeof value);
    for (std::size_t k = 0; k < sizeof value; ++k) value |= static_cast<Unsigned>(Unsigned{from[k]} << (8 * k));
    return value;
  }
  double real() { return std::bit_cast<double>(number<std::uint64_t>()); }
  std::string text() {
    const auto from = take(number<std::uint32_t>());
    return {from.begin(), from.end()};
  }

  std::size_t left() const { return bytes_.size(); }

 private:
  std::span<const unsigned char> take(std::uint64_t count) {
    if (count > bytes_.size()) throw OutOfBytes{};
    const auto taken = bytes_.first(static_cast<std::size_t>(count));
    bytes_ = bytes_.subspan(static_cast<std::size_t>(count));
    return taken;
  }

  std::span<const unsigned char> bytes_;
};

// FNV-1a, 64 bits. O(n).
inline std::uint64_t checksum(std::span<const unsigned char> bytes) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const unsigned char byte : bytes) hash = (hash ^ byte) * 0x100000001b3u;
  return hash;
}

}  // namespace cagewright::plugin
