// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_FILE_POLYGON_SOUP_H
#define CAGEWRIGHT_HOST_FILE_POLYGON_SOUP_H

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include "host/file/triangle_mesh.h"

namespace cagewright::host {

// Faces of any number of corners, as a file lists them.
struct PolygonSoup {
  std::vector<double> points;          // n x 3
  std::vector<std::uint32_t> corners;  // the faces' vertices, one face after the other
  std::vector<std::size_t> face_ends;  // one past the last corner of each face

  std::size_t vertex_count() const { return points.size() / 3; }
  void end_face() { face_ends.push_back(corners.size()); }
};

// Appends triangles that fill the polygon `corners` (at least 3, each a row of `points`), all in its direction, with
// exactly its edges as border: a fan where it is convex, ears clipped where it is not. A polygon that crosses itself,
// has no area, or has more than 1000 corners becomes a fan. O(1) for triangles, O(corners^2) as a rule.
void append_polygon(std::span<const double> points, std::span<const std::uint32_t> corners,
                    std::vector<std::uint32_t>& triangles);

// Every face as triangles, in the faces' order; degenerate faces and unused vertices stay. Throws FileError (path)
// where the soup has no vertices or no faces, a face has fewer than 3 corners, or names a vertex that is not there.
TriangleMesh triangulate(PolygonSoup soup, const std::filesystem::path& path);

}  // namespace cagewright::host

#endif
