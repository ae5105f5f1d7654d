// SPDX-License-Identifier: BSD-3-Clause
#include "host/file/mesh_writer.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "host/file/file_bytes.h"
#include "host/file/file_error.h"

namespace cagewright::host {
namespace {

void append(std::string& text, auto number) {
  std::array<char, 32> digits;
  const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), number);
  text.append(digits.data(), end);
}

void append_point(std::string& text, const double* p) {
  for (int k = 0; k < 3; ++k) {
    if (k > 0) text += ' ';
    append(text, p[k]);
  }
  text += '\n';
}

void append_points(std::string& text, const char* prefix, const TriangleMesh& mesh) {
  for (std::size_t i = 0; i < mesh.vertex_count(); ++i) {
    text += prefix;
    append_point(text, &mesh.points[3 * i]);
  }
}

void append_triangles(std::string& text, const char* prefix, std::uint64_t first, const TriangleMesh& mesh) {
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    text += i % 3 == 0 ? prefix : " ";
    append(text, mesh.triangles[i] + first);
    if (i % 3 == 2) text += '\n';
  }
}

std::string obj_text(const TriangleMesh& mesh) {
  std::string text;
  append_points(text, "v ", mesh);
  append_triangles(text, "f ", 1, mesh);
  return text;
}

std::string off_text(const TriangleMesh& mesh) {
  std::string text =
      "OFF\n" + std::to_string(mesh.vertex_count()) + " " + std::to_string(mesh.triangle_count()) + " 0\n";
  append_points(text, "", mesh);
  append_triangles(text, "3 ", 0, mesh);
  return text;
}

std::string ply_text(const TriangleMesh& mesh) {
  std::string text = "ply\nformat ascii 1.0\nelement vertex " + std::to_string(mesh.vertex_count()) +
                     "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
                     std::to_string(mesh.triangle_count()) + "\nproperty list uchar uint vertex_indices\nend_header\n";
  append_points(text, "", mesh);
  append_triangles(text, "3 ", 0, mesh);
  return text;
}

// Unit, scaled first so that neither large nor small triangles lose theirs; 0 for those without area, as STL has it.
std::array<double, 3> normal(const double* a, const double* b, const double* c) {
  std::array<double, 3> ab{}, ac{}, n{};
  double size = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    ab[k] = b[k] - a[k];
    ac[k] = c[k] - a[k];
    size = std::max({size, std::abs(ab[k]), std::abs(ac[k])});
  }
  if (!(size > 0)) return n;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t u = (k + 1) % 3, v = (k + 2) % 3;
    n[k] = (ab[u] / size) * (ac[v] / size) - (ab[v] / size) * (ac[u] / size);
  }
  const double length = std::hypot(n[0], n[1], n[2]);
  for (double& x : n) x = length > 0 ? x / length : 0;
  return n;
}

std::string stl_text(const TriangleMesh& mesh) {
  std::string text = "solid cagewright\n";
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    std::array<const double*, 3> corners{};
    for (std::size_t k = 0; k < 3; ++k) corners[k] = &mesh.points[3 * std::size_t{mesh.triangles[3 * t + k]}];
    text += "facet normal ";
    append_point(text, normal(corners[0], corners[1], corners[2]).data());
    text += "outer loop\n";
    for (const double* corner : corners) {
      text += "vertex ";
      append_point(text, corner);
    }
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid cagewright\n";
}

}  // namespace

bool is_writable_mesh_name(const std::filesystem::path& path) {
  const std::string ending = lower_ending(path);
  return ending == ".obj" || ending == ".off" || ending == ".ply" || ending == ".stl" || ending == ".glb";
}

std::string mesh_bytes(const TriangleMesh& mesh, const std::filesystem::path& path) {
  if (mesh.triangles.empty()) throw FileError(path, {}, "cannot be written: the mesh has no triangles");
  const std::string ending = lower_ending(path);
  if (ending == ".obj") return obj_text(mesh);
  if (ending == ".off") return off_text(mesh);
  if (ending == ".ply") return ply_text(mesh);
  if (ending == ".stl") return stl_text(mesh);
  if (ending == ".glb") return glb_bytes(mesh, "cage", path);
  throw FileError(path, {}, "cannot be written: the ending should be .obj, .off, .ply, .stl or .glb");
}

}  // namespace cagewright::host
