// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_FILE_PLY_HEADER_H
#define CAGEWRIGHT_HOST_FILE_PLY_HEADER_H

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace cagewright::host {

enum class PlyFormat { ascii, binary_little_endian, binary_big_endian };
enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

std::size_t byte_size(PlyType type);

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::float32;
  bool is_list = false;
  PlyType count_type = PlyType::uint8;  // of a list
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;
};

struct PlyHeader {
  PlyFormat format = PlyFormat::ascii;
  std::vector<PlyElement> elements;
  std::size_t size = 0;   // bytes up to the body
  std::size_t lines = 0;  // of the header
};

// Throws FileError with the line: not PLY, cut short, an unknown format, version, type or keyword.
PlyHeader read_ply_header(const std::filesystem::path& path, std::string_view bytes);

}  // namespace cagewright::host

#endif
