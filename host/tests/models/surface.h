// SPDX-License-Identifier: BSD-3-Clause
//
// Triangles as a file holds them, read and judged without any code of the program that is tested.
#ifndef CAGEWRIGHT_HOST_TESTS_MODELS_SURFACE_H
#define CAGEWRIGHT_HOST_TESTS_MODELS_SURFACE_H

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace cagewright::host {

struct Surface {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<std::array<std::size_t, 3>> triangles;  // from 0, counter-clockwise as seen from outside
};

// `v X Y Z` and `f A B C` lines and nothing else, as the program writes cages. Throws std::runtime_error, naming the
// line.
Surface obj_surface(const std::string& text);

// Files of numbers and triangles alone; `#` begins a comment. Throws std::runtime_error, naming the file.
Surface read_off(const std::filesystem::path& file);

// Numbers read back to the same bits.
std::string off_text(const Surface& surface);

// Vertices of the same position, to the bit, become one; those without a triangle stay.
Surface welded(const Surface& surface);

// Length of the bounding box's diagonal; at least one vertex.
double diagonal(const Surface& surface);

struct SurfaceFacts {
  std::size_t unpaired_edges = 0;  // directed edges that are not there exactly once, with the opposite exactly once
  std::size_t torn_vertices = 0;   // their triangles are not one closed fan; vertices without a triangle count
  std::ptrdiff_t euler = 0;        // vertices - edges + triangles
  double volume = 0;               // inside where the surface is closed; positive where it faces outward
};

// A closed, consistently oriented 2-manifold has no unpaired edge and no torn vertex. O(n log n).
SurfaceFacts facts_of(const Surface& surface);

}  // namespace cagewright::host

#endif
