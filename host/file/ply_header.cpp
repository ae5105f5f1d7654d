// SPDX-License-Identifier: BSD-3-Clause
#include "host/file/ply_header.h"

#include <algorithm>
#include <array>
#include <charconv>

#include "host/file/file_error.h"

namespace cagewright::host {
namespace {

struct TypeName {
  std::string_view name;
  PlyType type;
};
constexpr std::array<TypeName, 16> type_names = {{{"char", PlyType::int8},
                                                  {"int8", PlyType::int8},
                                                  {"uchar", PlyType::uint8},
                                                  {"uint8", PlyType::uint8},
                                                  {"short", PlyType::int16},
                                                  {"int16", PlyType::int16},
                                                  {"ushort", PlyType::uint16},
                                                  {"uint16", PlyType::uint16},
                                                  {"int", PlyType::int32},
                                                  {"int32", PlyType::int32},
                                                  {"uint", PlyType::uint32},
                                                  {"uint32", PlyType::uint32},
                                                  {"float", PlyType::float32},
                                                  {"float32", PlyType::float32},
                                                  {"double", PlyType::float64},
                                                  {"float64", PlyType::float64}}};

std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  while (true) {
    const std::size_t begin = line.find_first_not_of(" \t");
    if (begin == line.npos) return words;
    line.remove_prefix(begin);
    const std::size_t end = std::min(line.find_first_of(" \t"), line.size());
    words.push_back(line.substr(0, end));
    line.remove_prefix(end);
  }
}

class HeaderReader {
 public:
  HeaderReader(const std::filesystem::path& path, std::string_view bytes) : path_(path), bytes_(bytes) {}

  PlyHeader read() {
    choose_line_end();
    while (true) {
      const std::vector<std::string_view> words = words_of(next_line());
      if (words.empty() || words[0] == "comment" || words[0] == "obj_info") continue;
      if (words[0] == "end_header") break;
      read_statement(words);
    }
    if (!has_format_) fail("the header has no \"format\" line");
    header_.size = at_;
    header_.lines = line_;
    return std::move(header_);
  }

 private:
  // The first line's end is that of all: in a binary file the body's first byte may look like half of another.
  void choose_line_end() {
    if (!bytes_.starts_with("ply")) fail_at_start();
    const std::string_view rest = bytes_.substr(3);
    const std::size_t end = rest.find_first_not_of(" \t");
    if (end == rest.npos) fail("the file ends within the header");
    if (rest.substr(end).starts_with("\r\n")) {
      line_end_ = "\r\n";
    } else if (rest[end] == '\r' || rest[end] == '\n') {
      line_end_ = rest.substr(end, 1);
    } else {
      fail_at_start();
    }
    next_line();
  }

  [[noreturn]] void fail_at_start() const {
    throw FileError(path_, Line{1, 0}, "is not PLY: its first line should be \"ply\"");
  }

  std::string_view next_line() {
    const std::size_t end = bytes_.find(line_end_, at_);
    ++line_;
    if (end == bytes_.npos) fail("the file ends within the header; there is no \"end_header\"");
    std::string_view line = bytes_.substr(at_, end - at_);
    at_ = end + line_end_.size();
    return line;
  }

  void read_statement(const std::vector<std::string_view>& words) {
    if (words[0] == "format") return read_format(words);
    if (words[0] == "element") return read_element(words);
    if (words[0] == "property") return read_property(words);
    fail("is not PLY: there is no header line " + in_quotes(words[0]));
  }

  void read_format(const std::vector<std::string_view>& words) {
    if (words.size() != 3) fail("should be like \"format ascii 1.0\"");
    if (words[1] == "ascii") {
      header_.format = PlyFormat::ascii;
    } else if (words[1] == "binary_little_endian") {
      header_.format = PlyFormat::binary_little_endian;
    } else if (words[1] == "binary_big_endian") {
      header_.format = PlyFormat::binary_big_endian;
    } else {
      fail("the format " + in_quotes(words[1]) + " is unknown");
    }
    if (words[2] != "1.0") fail("PLY version " + in_quotes(words[2]) + " is unknown; only 1.0 can be read");
    has_format_ = true;
  }

  void read_element(const std::vector<std::string_view>& words) {
    PlyElement element;
    if (words.size() == 3) {
      const char* end = words[2].data() + words[2].size();
      const auto [stop, error] = std::from_chars(words[2].data(), end, element.count);
      if (error == std::errc() && stop == end) {
        element.name = words[1];
        header_.elements.push_back(std::move(element));
        return;
      }
    }
    fail("should be like \"element vertex 8\"");
  }

  void read_property(const std::vector<std::string_view>& words) {
    if (header_.elements.empty()) fail("a property comes before every element");
    PlyProperty property;
    if (words.size() == 3) {
      property.type = type_of(words[1]);
      property.name = words[2];
    } else if (words.size() == 5 && words[1] == "list") {
      property.is_list = true;
      property.count_type = type_of(words[2]);
      property.type = type_of(words[3]);
      property.name = words[4];
    } else {
      fail("should be like \"property float x\" or \"property list uchar int vertex_indices\"");
    }
    header_.elements.back().properties.push_back(std::move(property));
  }

  PlyType type_of(std::string_view name) const {
    for (const TypeName& known : type_names) {
      if (known.name == name) return known.type;
    }
    fail("the type " + in_quotes(name) + " is unknown");
  }

  [[noreturn]] void fail(const std::string& reason) const { throw FileError(path_, Line{line_, 0}, reason); }

  const std::filesystem::path& path_;
  std::string_view bytes_;
  std::string_view line_end_;
  std::size_t at_ = 0;
  std::size_t line_ = 0;
  bool has_format_ = false;
  PlyHeader header_;
};

}  // namespace

std::size_t byte_size(PlyType type) {
  switch (type) {
    case PlyType::int8:
    case PlyType::uint8:
      return 1;
    case PlyType::int16:
    case PlyType::uint16:
      return 2;
    case PlyType::int32:
    case PlyType::uint32:
    case PlyType::float32:
      return 4;
    case PlyType::float64:
      return 8;
  }
  return 8;
}

PlyHeader read_ply_header(const std::filesystem::path& path, std::string_view bytes) {
  return HeaderReader(path, bytes).read();
}

}  // namespace cagewright::host
