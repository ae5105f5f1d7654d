// SPDX-License-Identifier: BSD-3-Clause
#include "host/tests/scene/edited_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "host/file/file_bytes.h"
#include "host/tests/scene/scene_files.h"

namespace cagewright::host::test {
namespace {

double distance(const Point3& a, const Point3& b) { return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]); }

double dot(const Point3& a, const Point3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

}  // namespace

GltfJson json_of(const SceneDocument& scene) {
  return parse_gltf_json(scene.path(), json_text(scene.path(), scene.bytes()));
}

GltfJson json_of(const std::string& name) {
  const std::filesystem::path path = std::filesystem::path(CAGEWRIGHT_OWN_SCENES) / name;
  return parse_gltf_json(path, json_text(path, read_bytes(path)));
}

SceneDocument scene_of(const GltfJson& json, const std::string& name) {
  return SceneDocument(std::filesystem::path(CAGEWRIGHT_OWN_SCENES) / name, gltf_json_text(json));
}

SceneDocument edited(const std::string& name, const std::function<void(GltfJson&)>& edit) {
  GltfJson json = json_of(name);
  edit(json);
  return scene_of(json);
}

std::array<std::array<double, 4>, 3> transform_in(const GltfJson& node) {
  std::array<std::array<double, 4>, 3> m{};
  const auto numbers = [&](const char* key, std::vector<double> values) {
    for (std::size_t i = 0; find_key(node, key) && i < values.size(); ++i) values[i] = *number_in(node[key][i]);
    return values;
  };
  if (find_key(node, "matrix")) {
    const std::vector<double> columns = numbers("matrix", std::vector<double>(16));
    for (std::size_t row = 0; row < 3; ++row) {
      for (std::size_t column = 0; column < 4; ++column) m[row][column] = columns[4 * column + row];
    }
    return m;
  }
  const std::vector<double> t = numbers("translation", {0, 0, 0}), q = numbers("rotation", {0, 0, 0, 1}),
                            s = numbers("scale", {1, 1, 1});
  const double x = q[0], y = q[1], z = q[2], w = q[3];
  const std::array<std::array<double, 3>, 3> r = {
      {{1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)},
       {2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)},
       {2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)}}};
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column) m[row][column] = r[row][column] * s[column];
    m[row][3] = t[row];
  }
  return m;
}

Point3 mapped_up(const GltfJson& json, std::size_t node, std::size_t ancestor, Point3 point) {
  while (node != ancestor) {
    const auto m = transform_in(json["nodes"][node]);
    Point3 moved{};
    for (std::size_t row = 0; row < 3; ++row) moved[row] = dot({m[row][0], m[row][1], m[row][2]}, point) + m[row][3];
    point = moved;
    std::size_t parent = none;
    for (std::size_t i = 0; i < json["nodes"].size(); ++i) {
      const GltfJson* children = find_key(json["nodes"][i], "children");
      if (children && std::find(children->begin(), children->end(), node) != children->end()) parent = i;
    }
    if (parent == none) break;
    node = parent;
  }
  return point;
}

void expect_circle_maps_to(const Slide::Ellipse& ellipse, const GltfJson& json, std::size_t node,
                           std::size_t mesh_node) {
  for (int i = 0; i < 64; ++i) {
    const double angle = 2 * std::numbers::pi * i / 64, c = std::cos(angle), s = std::sin(angle);
    const Point3 expected = mapped_up(json, node, mesh_node, {c, s, 0});
    Point3 given{};
    for (std::size_t k = 0; k < 3; ++k) given[k] = ellipse.center[k] + c * ellipse.u[k] + s * ellipse.v[k];
    EXPECT_LE(distance(expected, given), 1e-12 * (1 + distance(expected, {}))) << "point " << i;
  }
}

SceneDocument as_it_is(const std::string& name) {
  return edited(name, [](GltfJson&) {});
}

bool has_note(const SceneDocument& scene, const std::string& part) {
  for (const std::string& note : scene.notes()) {
    if (note.find(part) != note.npos) return true;
  }
  return false;
}

GltfJson without_ours(SceneDocument& scene) {
  remove_all_of_ours(scene);
  return json_of(scene);
}

SceneDocument reloaded(const SceneDocument& scene) { return SceneDocument(scene.path(), scene.bytes()); }

SceneSlide slide_called(const SceneDocument& scene, const std::string& name) {
  std::vector<SceneSlide> found;
  for (const SceneSlide& slide : scene.slides()) {
    if (slide.name == name) found.push_back(slide);
  }
  if (found.size() == 1) return found.front();
  ADD_FAILURE() << found.size() << " slides are called " << name;
  return {};
}

void expect_ellipse(const Slide::Ellipse& expected, const Slide::Ellipse& given, double tolerance) {
  EXPECT_LE(distance(expected.center, given.center), tolerance) << testing::PrintToString(given.center);
  EXPECT_LE(distance(expected.u, given.u), tolerance) << testing::PrintToString(given.u);
  EXPECT_LE(distance(expected.v, given.v), tolerance) << testing::PrintToString(given.v);
}

void expect_same_curve(const Slide::Ellipse& expected, const Slide::Ellipse& given) {
  const Slide::Ellipse& e = expected;
  const double uu = dot(e.u, e.u), uv = dot(e.u, e.v), vv = dot(e.v, e.v), area = uu * vv - uv * uv;
  for (int i = 0; i < 64; ++i) {
    const double angle = 2 * std::numbers::pi * i / 64;
    Point3 p{}, nearest{};
    for (std::size_t k = 0; k < 3; ++k) {
      p[k] = given.center[k] + std::cos(angle) * given.u[k] + std::sin(angle) * given.v[k] - e.center[k];
    }
    const double pu = dot(p, e.u), pv = dot(p, e.v);
    const double a = (pu * vv - pv * uv) / area, b = (pv * uu - pu * uv) / area;
    for (std::size_t k = 0; k < 3; ++k) nearest[k] = a * e.u[k] + b * e.v[k];
    EXPECT_LE(distance(p, nearest), 1e-9 * std::sqrt(uu + vv)) << "point " << i << " is not in the plane";
    EXPECT_NEAR(a * a + b * b, 1, 1e-9) << "point " << i << " is not on the ellipse";
  }
}

}  // namespace cagewright::host::test
