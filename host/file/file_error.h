// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_FILE_FILE_ERROR_H
#define CAGEWRIGHT_HOST_FILE_FILE_ERROR_H

#include <cstddef>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>

namespace cagewright::host {

struct Line {
  std::size_t number = 0;  // from 1
  std::size_t column = 0;  // from 1, in bytes; 0: not known
};
struct Byte {
  std::size_t offset = 0;  // from 0
};
using FilePlace = std::variant<std::monostate, Line, Byte>;

// The one error of host/file. what() is one line: "PATH: REASON", with a place "PATH, line 7: REASON", "PATH, line 7,
// column 3: REASON" or "PATH, byte 84: REASON".
class FileError : public std::runtime_error {
 public:
  FileError(std::filesystem::path path, FilePlace place, const std::string& reason);

  const std::filesystem::path& path() const { return path_; }
  const FilePlace& place() const { return place_; }
  const std::string& reason() const { return reason_; }

 private:
  std::filesystem::path path_;
  FilePlace place_;
  std::string reason_;
};

// A piece of a file as sentences quote it: in double quotes, at most 40 bytes, control and non-ASCII bytes as '?'.
std::string in_quotes(std::string_view text);

// "1 triangle", "2 triangles", "2 vertices", "2 meshes".
std::string counted(std::size_t count, std::string_view noun);

}  // namespace cagewright::host

#endif
