// SPDX-License-Identifier: BSD-3-Clause
#include "plugin/tests/loaded_plugin.h"

#include <dlfcn.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

namespace cagewright::plugin::test {

const cgw_api& api() {
  static const cgw_api* table = [] {
    void* library = dlopen(CAGEWRIGHT_PLUGIN_FILE, RTLD_NOW | RTLD_LOCAL);
    if (!library) throw std::runtime_error(dlerror());
    const auto get_api = reinterpret_cast<cgw_get_api_fn>(dlsym(library, CGW_ENTRY_POINT));
    if (!get_api) throw std::runtime_error(dlerror());
    return get_api(CGW_ABI_MINOR);
  }();
  return *table;
}

cgw_mesh Mesh::view() const {
  cgw_mesh mesh = CGW_MESH_INIT;
  mesh.vertices = vertices.data();
  mesh.vertex_count = vertices.size() / 3;
  mesh.triangles = triangles.data();
  mesh.triangle_count = triangles.size() / 3;
  return mesh;
}

Mesh capsule() {
  constexpr std::uint32_t sides = 24, rings = 40;
  constexpr double pi = std::numbers::pi;
  Mesh mesh;
  for (std::uint32_t ring = 0; ring < rings; ++ring) {
    const double s = (ring + 1.0) / (rings + 1.0) * (pi + 6);  // length along the profile
    const double angle = s < pi / 2 ? s : s > pi / 2 + 6 ? s - 6 : pi / 2;
    const double x = s < pi / 2 ? -std::cos(angle) : s > pi / 2 + 6 ? 6 - std::cos(angle) : s - pi / 2;
    for (std::uint32_t side = 0; side < sides; ++side) {
      const double turn = 2 * pi * side / sides;
      mesh.vertices.insert(mesh.vertices.end(),
                           {x, std::sin(angle) * std::cos(turn), std::sin(angle) * std::sin(turn)});
    }
  }
  mesh.vertices.insert(mesh.vertices.end(), {-1, 0, 0, 7, 0, 0});
  for (std::uint32_t side = 0; side < sides; ++side) {
    const std::uint32_t next = (side + 1) % sides, first_pole = rings * sides, last = (rings - 1) * sides;
    mesh.triangles.insert(mesh.triangles.end(), {first_pole, next, side, first_pole + 1, last + side, last + next});
    for (std::uint32_t ring = 0; ring + 1 < rings; ++ring) {
      const std::uint32_t a = ring * sides + side, b = ring * sides + next;
      mesh.triangles.insert(mesh.triangles.end(), {a, b, b + sides, a, b + sides, a + sides});
    }
  }
  return mesh;
}

Mesh torus() {
  constexpr std::uint32_t around = 48, sides = 24;
  constexpr double pi = std::numbers::pi;
  Mesh mesh;
  for (std::uint32_t i = 0; i < around; ++i) {
    for (std::uint32_t j = 0; j < sides; ++j) {
      const double a = 2 * pi * i / around, b = 2 * pi * j / sides, radius = 3 + std::cos(b);
      mesh.vertices.insert(mesh.vertices.end(), {radius * std::cos(a), radius * std::sin(a), std::sin(b)});
      const std::uint32_t i1 = (i + 1) % around, j1 = (j + 1) % sides;
      const std::uint32_t p = i * sides + j, q = i1 * sides + j, r = i1 * sides + j1, s = i * sides + j1;
      mesh.triangles.insert(mesh.triangles.end(), {p, q, r, p, r, s});
    }
  }
  return mesh;
}

Mesh tetrahedron() { return {{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}, {0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2}}; }

Mesh turned_inside_out(Mesh mesh) {
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 3) std::swap(mesh.triangles[t], mesh.triangles[t + 1]);
  return mesh;
}

Session::Session(const cgw_host* host) {
  if (api().session_create(host, &handle_) != CGW_OK) throw std::runtime_error(api().last_error(nullptr));
}

Session::Session(const cgw_host* host, const Mesh& mesh) : Session(host) {
  const cgw_mesh view = mesh.view();
  if (api().set_mesh(handle_, &view) != CGW_OK) throw std::runtime_error(error());
}

Session::~Session() { api().session_destroy(handle_); }

std::string Session::error() const { return api().last_error(handle_); }

cgw_error_info Session::error_info() const {
  cgw_error_info info = CGW_ERROR_INFO_INIT;
  EXPECT_EQ(api().last_error_info(handle_, &info), CGW_OK);
  return info;
}

cgw_slide_input plane(const char* name, double x, double nx, double ny, double nz) {
  cgw_slide_input input = CGW_SLIDE_INPUT_INIT;
  input.kind = CGW_SLIDE_POINT_NORMAL;
  input.name = name;
  input.point[0] = x;
  input.normal[0] = nx;
  input.normal[1] = ny;
  input.normal[2] = nz;
  return input;
}

cgw_slide_input ellipse(const char* name, double x, double radius) {
  cgw_slide_input input = CGW_SLIDE_INPUT_INIT;
  input.kind = CGW_SLIDE_ELLIPSE;
  input.name = name;
  input.point[0] = x;
  input.u[1] = 1.2 * radius;
  input.v[2] = radius;
  return input;
}

cgw_slide_input point_alone(const char* name, double x) {
  cgw_slide_input input = CGW_SLIDE_INPUT_INIT;
  input.kind = CGW_SLIDE_POINT;
  input.name = name;
  input.point[0] = x;
  input.point[1] = 1;
  return input;
}

std::vector<double> stroke_points(double x, int count) {
  std::vector<double> points;
  for (int k = 0; k < count; ++k) {
    const double angle = 2 * std::numbers::pi * k / count;
    points.insert(points.end(), {x, std::cos(angle), std::sin(angle)});
  }
  return points;
}

cgw_slide_input stroke(const char* name, const std::vector<double>& points) {
  cgw_slide_input input = CGW_SLIDE_INPUT_INIT;
  input.kind = CGW_SLIDE_STROKE;
  input.name = name;
  input.stroke = points.data();
  input.stroke_count = points.size() / 3;
  return input;
}

std::uint64_t add(const Session& session, const cgw_slide_input& input) {
  std::uint64_t id = CGW_NO_ID;
  EXPECT_EQ(api().slide_add(session, &input, &id), CGW_OK) << session.error();
  return id;
}

cgw_slide_info info(const Session& session, std::uint64_t index) {
  cgw_slide_info info = CGW_SLIDE_INFO_INIT;
  EXPECT_EQ(api().slide_info(session, index, &info), CGW_OK) << session.error();
  return info;
}

SolvedCapsule::SolvedCapsule(const cgw_host* host) : session(host, capsule()) {
  left = add(session, plane("left", 1.01));
  middle = add(session, plane("middle", 3.02));
  right = add(session, plane("right", 4.97));
  if (api().solve(session, nullptr) != CGW_OK) throw std::runtime_error(session.error());
}

Cage cage_of(const Session& session) {
  cgw_cage view = CGW_CAGE_INIT;
  EXPECT_EQ(api().get_cage(session, &view), CGW_OK) << session.error();
  Cage cage{std::vector<double>(3 * view.vertex_count), std::vector<std::uint32_t>(3 * view.triangle_count)};
  view.vertices = cage.vertices.data();
  view.vertex_capacity = view.vertex_count;
  view.triangles = cage.triangles.data();
  view.triangle_capacity = view.triangle_count;
  EXPECT_EQ(api().get_cage(session, &view), CGW_OK) << session.error();
  return cage;
}

}  // namespace cagewright::plugin::test
