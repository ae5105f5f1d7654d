// SPDX-License-Identifier: BSD-3-Clause
#include "host/file/ply_values.h"

#include "host/file/byte_order.h"
#include "host/file/file_error.h"

namespace cagewright::host {

std::string PlyPlace::row_text() const { return element->name + " " + std::to_string(row); }
std::string PlyPlace::value_text() const { return property->name + " of " + row_text(); }

PlyTextValues::PlyTextValues(const std::filesystem::path& path, std::string_view bytes, const PlyHeader& header)
    : path_(path),
      scanner_(bytes.substr(header.size), path, {}),
      header_lines_(header.lines),
      size_(bytes.size() - header.size) {}

void PlyTextValues::begin_row(const PlyPlace& place) {
  if (!scanner_.next_line()) fail("the file ends before " + place.row_text());
}

void PlyTextValues::end_row(const PlyPlace& place) {
  if (scanner_.more_on_line()) fail("the line has more values than " + place.row_text() + " should have");
}

double PlyTextValues::next(PlyType, const PlyPlace& place) {
  const std::string_view word = scanner_.word_on_line();
  double value = 0;
  if (TextScanner::parse(word, value)) return value;
  if (word.empty()) fail("the line ends where " + place.value_text() + " should be");
  fail(place.value_text() + " should be a number, not " + in_quotes(word));
}

bool PlyTextValues::may_hold(std::uint64_t rows, std::size_t) const { return rows <= size_; }

bool PlyTextValues::at_end() { return !scanner_.next_line(); }

void PlyTextValues::fail(const std::string& reason) const {
  throw FileError(path_, Line{header_lines_ + scanner_.line(), 0}, reason);
}

PlyBinaryValues::PlyBinaryValues(const std::filesystem::path& path, std::string_view bytes, const PlyHeader& header)
    : path_(path),
      bytes_(bytes),
      at_(header.size),
      order_(header.format == PlyFormat::binary_big_endian ? std::endian::big : std::endian::little) {}

double PlyBinaryValues::next(PlyType type, const PlyPlace& place) {
  const std::size_t size = byte_size(type);
  if (bytes_.size() - at_ < size) fail("the file ends where " + place.value_text() + " should be");
  const char* from = bytes_.data() + at_;
  at_ += size;
  switch (type) {
    case PlyType::int8:
      return load<std::int8_t>(from, order_);
    case PlyType::uint8:
      return load<std::uint8_t>(from, order_);
    case PlyType::int16:
      return load<std::int16_t>(from, order_);
    case PlyType::uint16:
      return load<std::uint16_t>(from, order_);
    case PlyType::int32:
      return load<std::int32_t>(from, order_);
    case PlyType::uint32:
      return load<std::uint32_t>(from, order_);
    case PlyType::float32:
      return double{load<float>(from, order_)};
    case PlyType::float64:
      return load<double>(from, order_);
  }
  return 0;
}

bool PlyBinaryValues::may_hold(std::uint64_t rows, std::size_t row_bytes) const {
  return rows <= (bytes_.size() - at_) / row_bytes;
}

void PlyBinaryValues::fail(const std::string& reason) const { throw FileError(path_, Byte{at_}, reason); }

}  // namespace cagewright::host
