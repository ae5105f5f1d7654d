// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
#include <string>
#include <vector>

#include "host/file/file_error.h"
#include "host/file/mesh_reader.h"
#include "host/file/polygon_soup.h"
#include "host/file/text_scanner.h"

namespace cagewright::host {
namespace {

// Statements of the OBJ specification that say nothing about polygons, and the vendors' ones that are in wide use.
constexpr std::array<std::string_view, 37> skipped_statements = {
    "bevel",  "bmat", "c_interp", "call", "con",  "cstype", "csh",        "ctech",     "d_interp", "deg",
    "end",    "g",    "hole",     "l",    "lod",  "maplib", "mg",         "mtllib",    "o",        "p",
    "parm",   "s",    "scrv",     "sp",   "step", "stech",  "shadow_obj", "trace_obj", "trim",     "usemap",
    "usemtl", "vn",   "vp",       "vt",   "bsp",  "res",    "cdc"};
constexpr std::array<std::string_view, 3> free_form_statements = {"curv", "curv2", "surf"};

bool contains(const auto& words, std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

class ObjReader {
 public:
  ObjReader(const std::filesystem::path& path, std::string_view bytes)
      : path_(path), scanner_(bytes, path, {.comment = '#', .continuation = '\\'}) {}

  MeshFile read() {
    while (scanner_.next_line()) read_statement();
    check_forward_references();
    MeshFile result{triangulate(std::move(soup_), path_), {}};
    if (free_form_ > 0) {
      result.notes.push_back(path_.string() + ": " + counted(free_form_, "free-form curve or surface statement") +
                             " skipped; only its polygons are used");
    }
    return result;
  }

 private:
  void read_statement() {
    const std::string_view statement = scanner_.word_on_line();
    if (statement == "v") return read_vertex();
    if (statement == "f" || statement == "fo") return read_face();
    if (contains(skipped_statements, statement)) return;
    if (!contains(free_form_statements, statement)) {
      scanner_.fail("is not OBJ: there is no statement " + in_quotes(statement));
    }
    ++free_form_;
  }

  // x y z, then nothing, w, a colour, or w and a colour.
  void read_vertex() {
    constexpr std::array<std::string_view, 3> names = {"the x of a vertex", "the y of a vertex", "the z of a vertex"};
    for (const std::string_view name : names) {
      soup_.points.push_back(scanner_.to_coordinate(scanner_.word_on_line(), name));
    }
    for (std::size_t extra = 0; scanner_.more_on_line(); ++extra) {
      if (extra == 4) scanner_.fail("a vertex has more than 7 numbers");
      scanner_.to_number(scanner_.word_on_line(), "a weight or colour of a vertex");
    }
    if (soup_.vertex_count() > std::numeric_limits<std::uint32_t>::max()) scanner_.fail("has too many vertices");
  }

  void read_face() {
    std::size_t corners = 0;
    for (; scanner_.more_on_line(); ++corners) soup_.corners.push_back(corner(scanner_.word_on_line()));
    if (corners < 3) {
      scanner_.fail("face " + std::to_string(soup_.face_ends.size() + 1) + " has " + counted(corners, "corner") +
                    "; it needs at least 3");
    }
    soup_.end_face();
  }

  // The vertex of "7", "7/1", "7//3", "7/1/3"; -1 is the last one so far.
  std::uint32_t corner(std::string_view word) {
    const std::string_view index_text = word.substr(0, word.find('/'));
    if (word.find_first_not_of("+-0123456789/") != word.npos || index_text.empty()) {
      scanner_.fail("a corner of a face should be like 7, 7/1, 7//3 or 7/1/3, not " + in_quotes(word));
    }
    const std::int64_t index = scanner_.to_integer(index_text, "a corner of a face");
    const auto vertices = static_cast<std::int64_t>(soup_.vertex_count());
    const std::int64_t vertex = index < 0 ? vertices + index : index - 1;
    if (index == 0 || vertex < 0 || vertex > std::numeric_limits<std::uint32_t>::max()) fail_out_of_range(index);
    if (vertex >= vertices) forward_.push_back({scanner_.line(), soup_.face_ends.size(), index});
    return static_cast<std::uint32_t>(vertex);
  }

  [[noreturn]] void fail_out_of_range(std::int64_t index) {
    scanner_.fail(out_of_range(soup_.face_ends.size(), index) + " so far (vertices count from 1)");
  }

  std::string out_of_range(std::size_t face, std::int64_t index) const {
    return "face " + std::to_string(face + 1) + " names vertex " + std::to_string(index) + ", but there are only " +
           counted(soup_.vertex_count(), "vertex");
  }

  // Some programs write faces before their vertices; only at the end can one tell.
  void check_forward_references() const {
    for (const ForwardReference& reference : forward_) {
      if (static_cast<std::uint64_t>(reference.index) <= soup_.vertex_count()) continue;
      throw FileError(path_, Line{reference.line, 0}, out_of_range(reference.face, reference.index));
    }
  }

  struct ForwardReference {
    std::size_t line;
    std::size_t face;
    std::int64_t index;
  };

  const std::filesystem::path& path_;
  TextScanner scanner_;
  PolygonSoup soup_;
  std::vector<ForwardReference> forward_;
  std::size_t free_form_ = 0;
};

}  // namespace

MeshFile read_obj(const std::filesystem::path& path, std::string_view bytes) { return ObjReader(path, bytes).read(); }

}  // namespace cagewright::host
