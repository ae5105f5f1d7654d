// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "host/file/file_error.h"
#include "host/file/mesh_reader.h"
#include "host/file/ply_header.h"
#include "host/file/ply_values.h"
#include "host/file/polygon_soup.h"

namespace cagewright::host {
namespace {

// What a property means to us.
enum class Role { x, y, z, face, strip, skipped };

Role role_of(const PlyElement& element, const PlyProperty& property) {
  if (element.name == "vertex" && !property.is_list) {
    if (property.name == "x") return Role::x;
    if (property.name == "y") return Role::y;
    if (property.name == "z") return Role::z;
  }
  const bool is_index_list = property.is_list && (property.name == "vertex_indices" || property.name == "vertex_index");
  if (is_index_list && element.name == "face") return Role::face;
  if (is_index_list && element.name == "tristrips") return Role::strip;
  return Role::skipped;
}

template <class Values>
class BodyReader {
 public:
  BodyReader(const std::filesystem::path& path, Values values) : path_(path), values_(std::move(values)) {}

  MeshFile read(const PlyHeader& header) {
    for (const PlyElement& element : header.elements) read_element(element);
    MeshFile result;
    if (!values_.at_end()) result.notes.push_back(path_.string() + ": what follows the last element was not read");
    result.mesh = triangulate(std::move(soup_), path_);
    return result;
  }

 private:
  void read_element(const PlyElement& element) {
    if (element.properties.empty()) return;
    std::size_t least_bytes = 0;
    std::vector<Role> roles;
    for (const PlyProperty& property : element.properties) {
      least_bytes += byte_size(property.is_list ? property.count_type : property.type);
      roles.push_back(role_of(element, property));
    }
    check_roles(element, roles);
    if (!values_.may_hold(element.count, least_bytes)) {
      values_.fail("the header promises " + std::to_string(element.count) + " of element " + in_quotes(element.name) +
                   ", more than the file can hold");
    }
    if (element.name == "vertex") soup_.points.reserve(3 * element.count);
    place_.element = &element;
    for (place_.row = 0; place_.row < element.count; ++place_.row) read_row(roles);
  }

  void check_roles(const PlyElement& element, const std::vector<Role>& roles) const {
    const auto lacks = [&roles](Role role) { return std::find(roles.begin(), roles.end(), role) == roles.end(); };
    if (element.name == "vertex" && (lacks(Role::x) || lacks(Role::y) || lacks(Role::z))) {
      throw FileError(path_, {}, "its vertices have no x, y and z");
    }
    if ((element.name == "face" && lacks(Role::face)) || (element.name == "tristrips" && lacks(Role::strip))) {
      throw FileError(path_, {}, "its element " + in_quotes(element.name) + " has no list \"vertex_indices\"");
    }
  }

  void read_row(const std::vector<Role>& roles) {
    values_.begin_row(place_);
    std::array<double, 3> position{};
    for (std::size_t i = 0; i < roles.size(); ++i) {
      place_.property = &place_.element->properties[i];
      if (roles[i] == Role::face) {
        read_face();
      } else if (roles[i] == Role::strip) {
        read_strip();
      } else if (roles[i] == Role::skipped) {
        skip();
      } else {
        position[static_cast<std::size_t>(roles[i])] = coordinate();
      }
    }
    values_.end_row(place_);
    if (place_.element->name == "vertex") soup_.points.insert(soup_.points.end(), position.begin(), position.end());
  }

  double coordinate() {
    const double value = values_.next(place_.property->type, place_);
    if (!std::isfinite(value)) values_.fail(place_.value_text() + " is not finite");
    return value;
  }

  std::uint64_t list_length() {
    const double length = values_.next(place_.property->count_type, place_);
    if (!(length >= 0) || length != std::floor(length) || length > std::numeric_limits<std::uint32_t>::max()) {
      values_.fail("the length of " + place_.value_text() + " is no count");
    }
    return static_cast<std::uint64_t>(length);
  }

  void skip() {
    if (!place_.property->is_list) {
      values_.next(place_.property->type, place_);
      return;
    }
    for (std::uint64_t left = list_length(); left > 0; --left) values_.next(place_.property->type, place_);
  }

  // A row of the vertices, or -1 where the file says so.
  std::int64_t index() {
    const double value = values_.next(place_.property->type, place_);
    if (!(value >= -1) || value != std::floor(value) || value > std::numeric_limits<std::uint32_t>::max()) {
      values_.fail(place_.value_text() + " should hold rows of vertices, from 0");
    }
    return static_cast<std::int64_t>(value);
  }

  void read_face() {
    const std::uint64_t corners = list_length();
    if (corners < 3) values_.fail(place_.row_text() + " has " + counted(corners, "corner") + "; it needs at least 3");
    for (std::uint64_t i = 0; i < corners; ++i) {
      const std::int64_t vertex = index();
      if (vertex < 0) values_.fail(place_.row_text() + " names vertex -1");
      soup_.corners.push_back(static_cast<std::uint32_t>(vertex));
    }
    soup_.end_face();
  }

  // -1 begins a new strip. Triangles without area are how strips turn corners, so they are no faces.
  void read_strip() {
    std::array<std::uint32_t, 2> last{};
    std::size_t length = 0;
    for (std::uint64_t left = list_length(); left > 0; --left) {
      const std::int64_t next = index();
      if (next < 0) {
        length = 0;
        continue;
      }
      const auto vertex = static_cast<std::uint32_t>(next);
      ++length;
      if (length > 2 && last[0] != last[1] && last[0] != vertex && last[1] != vertex) {
        const bool is_even = length % 2 == 1;
        soup_.corners.insert(soup_.corners.end(), {last[is_even ? 0 : 1], last[is_even ? 1 : 0], vertex});
        soup_.end_face();
      }
      last = {last[1], vertex};
    }
  }

  const std::filesystem::path& path_;
  Values values_;
  PlyPlace place_;
  PolygonSoup soup_;
};

}  // namespace

MeshFile read_ply(const std::filesystem::path& path, std::string_view bytes) {
  const PlyHeader header = read_ply_header(path, bytes);
  if (header.format == PlyFormat::ascii) {
    return BodyReader(path, PlyTextValues(path, bytes, header)).read(header);
  }
  return BodyReader(path, PlyBinaryValues(path, bytes, header)).read(header);
}

}  // namespace cagewright::host
