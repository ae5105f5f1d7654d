// SPDX-License-Identifier: BSD-3-Clause
#include "host/file/polygon_soup.h"

#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "host/file/file_error.h"

namespace cagewright::host {
namespace {

constexpr std::size_t most_corners_to_clip = 1000;

struct Corner {
  std::uint32_t vertex = 0;
  double x = 0, y = 0;
};

// Twice the signed area of a, b, c.
double turn(const Corner& a, const Corner& b, const Corner& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// Newell's normal: twice the area vector, whatever the corners' order of magnitude or convexity.
std::array<double, 3> area_vector(std::span<const double> points, std::span<const std::uint32_t> corners) {
  std::array<double, 3> sum{};
  const double* origin = &points[3 * std::size_t{corners[0]}];
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const double* a = &points[3 * std::size_t{corners[i]}];
    const double* b = &points[3 * std::size_t{corners[(i + 1) % corners.size()]}];
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t u = (k + 1) % 3, v = (k + 2) % 3;
      sum[k] += (a[u] - origin[u]) * (b[v] - origin[v]) - (a[v] - origin[v]) * (b[u] - origin[u]);
    }
  }
  return sum;
}

// The polygon in the coordinate plane that shows most of it, counter-clockwise; empty where it has no area.
std::vector<Corner> flatten(std::span<const double> points, std::span<const std::uint32_t> corners) {
  const std::array<double, 3> area = area_vector(points, corners);
  std::size_t axis = std::abs(area[0]) > std::abs(area[1]) ? 0 : 1;
  if (std::abs(area[2]) > std::abs(area[axis])) axis = 2;
  if (!(std::abs(area[axis]) > 0)) return {};
  const double sign = area[axis] > 0 ? 1 : -1;
  std::vector<Corner> flat;
  flat.reserve(corners.size());
  for (const std::uint32_t vertex : corners) {
    const double* p = &points[3 * std::size_t{vertex}];
    flat.push_back({vertex, p[(axis + 1) % 3], sign * p[(axis + 2) % 3]});
  }
  return flat;
}

bool is_strictly_convex(const std::vector<Corner>& polygon) {
  const std::size_t n = polygon.size();
  for (std::size_t i = 0; i < n; ++i) {
    if (!(turn(polygon[i], polygon[(i + 1) % n], polygon[(i + 2) % n]) > 0)) return false;
  }
  return true;
}

bool same_place(const Corner& a, const Corner& b) { return a.x == b.x && a.y == b.y; }

bool is_ear(const std::vector<Corner>& polygon, std::size_t i) {
  const std::size_t n = polygon.size();
  const Corner &a = polygon[(i + n - 1) % n], &b = polygon[i], &c = polygon[(i + 1) % n];
  if (!(turn(a, b, c) > 0)) return false;
  for (const Corner& p : polygon) {
    // A polygon with a hole comes as one ring that visits the bridge's ends twice.
    if (same_place(p, a) || same_place(p, b) || same_place(p, c)) continue;
    if (turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0) return false;
  }
  return true;
}

void append_fan(std::span<const std::uint32_t> corners, std::vector<std::uint32_t>& triangles) {
  for (std::size_t i = 2; i < corners.size(); ++i) {
    triangles.insert(triangles.end(), {corners[0], corners[i - 1], corners[i]});
  }
}

void clip_ears(std::vector<Corner> polygon, std::vector<std::uint32_t>& triangles) {
  while (polygon.size() > 3) {
    std::size_t ear = 0;
    while (ear < polygon.size() && !is_ear(polygon, ear)) ++ear;
    if (ear == polygon.size()) break;  // it crosses itself
    const std::size_t n = polygon.size();
    triangles.insert(triangles.end(),
                     {polygon[(ear + n - 1) % n].vertex, polygon[ear].vertex, polygon[(ear + 1) % n].vertex});
    polygon.erase(polygon.begin() + static_cast<std::ptrdiff_t>(ear));
  }
  std::vector<std::uint32_t> rest;
  for (const Corner& corner : polygon) rest.push_back(corner.vertex);
  append_fan(rest, triangles);
}

void check(const PolygonSoup& soup, const std::filesystem::path& path) {
  const std::size_t vertices = soup.vertex_count();
  if (vertices == 0) throw FileError(path, {}, "is not a mesh: it holds no vertices");
  if (soup.face_ends.empty()) {
    throw FileError(path, {}, "holds " + counted(vertices, "vertex") + " but no triangles; a closed surface is needed");
  }
  std::size_t begin = 0;
  for (std::size_t face = 0; face < soup.face_ends.size(); ++face) {
    const std::size_t end = soup.face_ends[face];
    const std::string name = "face " + std::to_string(face);
    if (end - begin < 3) throw FileError(path, {}, name + " has fewer than 3 corners (faces count from 0)");
    for (; begin < end; ++begin) {
      if (soup.corners[begin] < vertices) continue;
      throw FileError(path, {},
                      name + " names vertex " + std::to_string(soup.corners[begin]) + ", but there are only " +
                          counted(vertices, "vertex") + " (both count from 0)");
    }
  }
}

}  // namespace

void append_polygon(std::span<const double> points, std::span<const std::uint32_t> corners,
                    std::vector<std::uint32_t>& triangles) {
  if (corners.size() > 3 && corners.size() <= most_corners_to_clip) {
    std::vector<Corner> polygon = flatten(points, corners);
    if (!polygon.empty() && !is_strictly_convex(polygon)) return clip_ears(std::move(polygon), triangles);
  }
  append_fan(corners, triangles);
}

TriangleMesh triangulate(PolygonSoup soup, const std::filesystem::path& path) {
  check(soup, path);
  TriangleMesh mesh{std::move(soup.points), {}};
  if (soup.corners.size() == 3 * soup.face_ends.size()) {  // only triangles, as check saw none smaller
    mesh.triangles = std::move(soup.corners);
    return mesh;
  }
  mesh.triangles.reserve(3 * (soup.corners.size() - 2 * soup.face_ends.size()));
  std::size_t begin = 0;
  for (const std::size_t end : soup.face_ends) {
    append_polygon(mesh.points, std::span(soup.corners).subspan(begin, end - begin), mesh.triangles);
    begin = end;
  }
  return mesh;
}

}  // namespace cagewright::host
