// SPDX-License-Identifier: BSD-3-Clause
#include "plugin/src/input.h"

#include <limits>
#include <string>

#include "plugin/src/abi_struct.h"

namespace cagewright::plugin {

namespace {

constexpr std::uint64_t row_limit = std::numeric_limits<int>::max();

[[noreturn]] void refuse(const std::string& sentence) { throw AbiError(CGW_ERROR_INVALID_ARGUMENT, sentence); }

void check_rows(const void* rows, std::uint64_t count, const char* what) {
  if (!rows && count > 0) refuse(std::string(what) + " is NULL, but its count is " + std::to_string(count));
  if (count > row_limit) {
    refuse(std::string(what) + " has " + std::to_string(count) + " rows; at most " + std::to_string(row_limit) +
           " are possible");
  }
}

Points to_points(const double* rows, std::uint64_t count) {
  if (count == 0) return Points(0, 3);
  return Eigen::Map<const Points>(rows, static_cast<Eigen::Index>(count), 3);
}

Triangles to_triangles(const cgw_mesh& mesh) {
  Triangles triangles(static_cast<Eigen::Index>(mesh.triangle_count), 3);
  for (std::uint64_t t = 0; t < mesh.triangle_count; ++t) {
    for (std::uint64_t i = 0; i < 3; ++i) {
      const std::uint32_t vertex = mesh.triangles[3 * t + i];
      if (vertex >= mesh.vertex_count) {
        cgw_error_info info = CGW_ERROR_INFO_INIT;
        info.code = CGW_ERROR_MESH_INDEX;
        info.element = t;
        throw AbiError(info, "triangle " + std::to_string(t) + " names vertex " + std::to_string(vertex) +
                                 ", but there are only " + std::to_string(mesh.vertex_count) +
                                 " vertices; indices count from 0");
      }
      triangles(static_cast<Eigen::Index>(t), static_cast<Eigen::Index>(i)) = static_cast<int>(vertex);
    }
  }
  return triangles;
}

// Length of the UTF-8 character that begins at `text` (which ends with a 0), or 0 where none does.
std::size_t utf8_length(const unsigned char* text) {
  const unsigned char first = text[0];
  if (first < 0x80) return 1;
  const std::size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first < 0xC2 || first > 0xF4) return 0;
  for (std::size_t k = 1; k < length; ++k) {
    if ((text[k] & 0xC0u) != 0x80) return 0;
  }
  const bool overlong = (first == 0xE0 && text[1] < 0xA0) || (first == 0xF0 && text[1] < 0x90);
  const bool no_character = (first == 0xED && text[1] >= 0xA0) || (first == 0xF4 && text[1] >= 0x90);
  return overlong || no_character ? 0 : length;
}

// Precondition: not NULL.
std::string to_name(const char* name) {
  for (const auto* at = reinterpret_cast<const unsigned char*>(name); *at != 0;) {
    const std::size_t length = utf8_length(at);
    if (length == 0) {
      const auto byte = at - reinterpret_cast<const unsigned char*>(name);
      refuse("the name of a slide is not UTF-8 from its byte " + std::to_string(byte) + " on");
    }
    at += length;
  }
  return name;
}

cgw_slide_input read_input(const cgw_slide_input* given) {
  return read_struct<cgw_slide_input>(given, CGW_SLIDE_INPUT_INIT, "cgw_slide_input");
}

Vector3 to_vector(const double (&xyz)[3]) { return {xyz[0], xyz[1], xyz[2]}; }

SlideDefinition to_definition(const cgw_slide_input& input, const std::string& name) {
  switch (input.kind) {
    case CGW_SLIDE_STROKE:
      check_rows(input.stroke, input.stroke_count, "the stroke of a slide");
      return StrokeDefinition{to_points(input.stroke, input.stroke_count)};
    case CGW_SLIDE_POINT_NORMAL:
      return PointNormalDefinition{to_vector(input.point), to_vector(input.normal)};
    case CGW_SLIDE_ELLIPSE:
      return EllipseDefinition{to_vector(input.point), to_vector(input.u), to_vector(input.v)};
    case CGW_SLIDE_POINT:
      return PointDefinition{to_vector(input.point)};
    default:
      refuse(slide_text(name) + ": kind " + std::to_string(input.kind) + " is none of CGW_SLIDE_*");
  }
}

}  // namespace

IndexedMesh to_mesh(const cgw_mesh* given) {
  const cgw_mesh mesh = read_struct<cgw_mesh>(given, CGW_MESH_INIT, "cgw_mesh");
  check_rows(mesh.vertices, mesh.vertex_count, "the vertices of the mesh");
  check_rows(mesh.triangles, mesh.triangle_count, "the triangles of the mesh");
  return {to_points(mesh.vertices, mesh.vertex_count), to_triangles(mesh)};
}

Slide to_slide(const cgw_slide_input* given) {
  const cgw_slide_input input = read_input(given);
  if (!input.name) refuse("the name of a slide is NULL; give it one that no other slide has");
  if (*input.name == '\0') throw AbiError(CGW_ERROR_SLIDE_NAME, "the name of a slide is empty; give it one");
  return to_slide_or_nameless(given);
}

Slide to_slide_or_nameless(const cgw_slide_input* given) {
  const cgw_slide_input input = read_input(given);
  std::string name = to_name(input.name ? input.name : "");
  SlideDefinition definition = to_definition(input, name);
  return {std::move(name), std::move(definition)};
}

}  // namespace cagewright::plugin
