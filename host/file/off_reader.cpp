// SPDX-License-Identifier: BSD-3-Clause
#include <limits>
#include <string>

#include "host/file/file_error.h"
#include "host/file/mesh_reader.h"
#include "host/file/polygon_soup.h"
#include "host/file/text_scanner.h"

namespace cagewright::host {
namespace {

class OffReader {
 public:
  OffReader(const std::filesystem::path& path, std::string_view bytes)
      : path_(path), size_(bytes.size()), scanner_(bytes, path, {.comment = '#'}) {}

  MeshFile read() {
    read_header();
    soup_.points.reserve(3 * vertices_);
    for (std::size_t i = 0; i < vertices_; ++i) read_vertex(i);
    soup_.corners.reserve(3 * faces_);
    soup_.face_ends.reserve(faces_);
    for (std::size_t i = 0; i < faces_; ++i) read_face(i);
    MeshFile result{{}, {}};
    if (!scanner_.at_end()) {
      result.notes.push_back(path_.string() + ", line " + std::to_string(scanner_.line()) +
                             ": what follows the last of " + counted(faces_, "face") + " was not read");
    }
    result.mesh = triangulate(std::move(soup_), path_);
    return result;
  }

 private:
  // [ST][C][N]OFF, then the counts on the same or the next line; the number of edges may be missing.
  void read_header() {
    if (!scanner_.next_line()) scanner_.fail("is not OFF: the file is empty");
    std::string_view word = scanner_.word_on_line();
    if (word.ends_with("OFF")) {
      check_variant(word);
      word = scanner_.word("the number of vertices");
      if (word == "BINARY") scanner_.fail("is a binary OFF file, which cannot be read; save it as text OFF or PLY");
    } else if (word.find_first_not_of("0123456789") != word.npos) {
      scanner_.fail("is not OFF: it should begin with OFF, not " + in_quotes(word));
    }
    vertices_ = count(word, "the number of vertices");
    faces_ = count(scanner_.word("the number of faces"), "the number of faces");
    if (scanner_.more_on_line()) scanner_.to_integer(scanner_.word_on_line(), "the number of edges");
    if (scanner_.more_on_line()) scanner_.fail("after the counts comes " + in_quotes(scanner_.word_on_line()));
    // A vertex takes 6 bytes at least, a face 8, but for the last line's end.
    if (vertices_ > size_ / 6 + 1 || faces_ > size_ / 6 + 1) {
      scanner_.fail("promises " + counted(vertices_, "vertex") + " and " + counted(faces_, "face") +
                    ", more than the file can hold");
    }
  }

  void check_variant(std::string_view keyword) {
    std::string_view prefix = keyword.substr(0, keyword.size() - 3);
    if (prefix.find('4') != prefix.npos || prefix.find('n') != prefix.npos) {
      scanner_.fail("is " + in_quotes(keyword) + ", whose points are not in 3-D space; save it as OFF");
    }
    for (const std::string_view part : {"ST", "C", "N"}) {
      if (prefix.starts_with(part)) prefix.remove_prefix(part.size());
    }
    if (!prefix.empty()) scanner_.fail("is not OFF: it should begin with OFF, not " + in_quotes(keyword));
  }

  std::size_t count(std::string_view word, std::string_view what) {
    const std::int64_t value = scanner_.to_integer(word, what);
    if (value < 0) scanner_.fail(std::string(what) + " is negative: " + in_quotes(word));
    if (value > std::numeric_limits<std::uint32_t>::max()) scanner_.fail(std::string(what) + " is too large");
    return static_cast<std::size_t>(value);
  }

  // Position first in every variant; normals, colours and texture coordinates follow on the line.
  void read_vertex(std::size_t i) {
    if (scanner_.at_end()) fail_short("vertex", i, vertices_);
    for (int k = 0; k < 3; ++k) {
      soup_.points.push_back(scanner_.to_coordinate(scanner_.word("a coordinate of a vertex"),
                                                    "a coordinate of vertex " + std::to_string(i)));
    }
    skip_numbers("vertex", i);
  }

  void read_face(std::size_t i) {
    if (scanner_.at_end()) fail_short("face", i, faces_);
    const std::int64_t corners = scanner_.to_integer(scanner_.word("a face"), "the number of corners of a face");
    if (corners < 3) {
      scanner_.fail(
          "face " + std::to_string(i) + " has " +
          (corners < 0 ? std::to_string(corners) + " corners" : counted(static_cast<std::size_t>(corners), "corner")) +
          "; it needs at least 3");
    }
    for (std::int64_t k = 0; k < corners; ++k) {
      const std::int64_t vertex = scanner_.to_integer(scanner_.word("a corner of a face"), "a corner of a face");
      if (vertex < 0 || vertex >= static_cast<std::int64_t>(vertices_)) {
        scanner_.fail("face " + std::to_string(i) + " names vertex " + std::to_string(vertex) +
                      ", but there are only " + counted(vertices_, "vertex") + " (both count from 0)");
      }
      soup_.corners.push_back(static_cast<std::uint32_t>(vertex));
    }
    skip_numbers("face", i);
    soup_.end_face();
  }

  void skip_numbers(const char* element, std::size_t i) {
    while (scanner_.more_on_line()) {
      scanner_.to_number(scanner_.word_on_line(),
                         "a colour or other value of " + std::string(element) + " " + std::to_string(i));
    }
  }

  [[noreturn]] void fail_short(const char* element, std::size_t have, std::size_t promised) {
    scanner_.fail("the file ends after " + counted(have, element) + " of " + std::to_string(promised));
  }

  const std::filesystem::path& path_;
  std::size_t size_;
  TextScanner scanner_;
  PolygonSoup soup_;
  std::size_t vertices_ = 0;
  std::size_t faces_ = 0;
};

}  // namespace

MeshFile read_off(const std::filesystem::path& path, std::string_view bytes) { return OffReader(path, bytes).read(); }

}  // namespace cagewright::host
