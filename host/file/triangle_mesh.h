// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_FILE_TRIANGLE_MESH_H
#define CAGEWRIGHT_HOST_FILE_TRIANGLE_MESH_H

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace cagewright::host {

// Triangles as a file holds them: nothing welded, dropped or turned.
struct TriangleMesh {
  std::vector<double> points;            // n x 3, row = vertex, finite
  std::vector<std::uint32_t> triangles;  // m x 3, row = triangle, counter-clockwise from outside, each < n

  std::size_t vertex_count() const { return points.size() / 3; }
  std::size_t triangle_count() const { return triangles.size() / 3; }
};

// A mesh that was read, and what the user should know about how: one sentence each, naming the file.
struct MeshFile {
  TriangleMesh mesh;
  std::vector<std::string> notes;
};

}  // namespace cagewright::host

#endif
