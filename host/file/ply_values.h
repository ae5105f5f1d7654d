// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_FILE_PLY_VALUES_H
#define CAGEWRIGHT_HOST_FILE_PLY_VALUES_H

#include <bit>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "host/file/ply_header.h"
#include "host/file/text_scanner.h"

namespace cagewright::host {

// Where a value stands; becomes words only when something is wrong.
struct PlyPlace {
  const PlyElement* element = nullptr;
  std::uint64_t row = 0;
  const PlyProperty* property = nullptr;

  std::string row_text() const;    // vertex 7
  std::string value_text() const;  // x of vertex 7
};

// The values of a PLY body, one after the other, as doubles, which hold every PLY type exactly. Both classes have the
// same functions; every failure is a FileError with the line or byte.

class PlyTextValues {
 public:
  PlyTextValues(const std::filesystem::path& path, std::string_view bytes, const PlyHeader& header);

  void begin_row(const PlyPlace& place);  // a row is a line
  void end_row(const PlyPlace& place);
  double next(PlyType type, const PlyPlace& place);
  bool may_hold(std::uint64_t rows, std::size_t row_bytes) const;  // whether so much can still come
  bool at_end();
  [[noreturn]] void fail(const std::string& reason) const;

 private:
  const std::filesystem::path& path_;
  TextScanner scanner_;
  std::size_t header_lines_;
  std::size_t size_;
};

class PlyBinaryValues {
 public:
  PlyBinaryValues(const std::filesystem::path& path, std::string_view bytes, const PlyHeader& header);

  void begin_row(const PlyPlace&) {}
  void end_row(const PlyPlace&) {}
  double next(PlyType type, const PlyPlace& place);
  bool may_hold(std::uint64_t rows, std::size_t row_bytes) const;
  bool at_end() const { return at_ == bytes_.size(); }
  [[noreturn]] void fail(const std::string& reason) const;

 private:
  const std::filesystem::path& path_;
  std::string_view bytes_;
  std::size_t at_;
  std::endian order_;
};

}  // namespace cagewright::host

#endif
