// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_TESTS_SAMPLE_MESHES_H
#define CAGEWRIGHT_HOST_TESTS_SAMPLE_MESHES_H

#include <array>
#include <cstdint>
#include <vector>

#include "host/file/triangle_mesh.h"

namespace cagewright::host {

using Points = std::vector<double>;
using Rows = std::vector<std::uint32_t>;

// Closed, from (0,0,0) to (1,1,1), 8 vertices, 12 triangles.
TriangleMesh unit_cube();

// Random positions of every order of magnitude that fits a float, and random triangles: non-manifold, repeated and
// degenerate ones and unused vertices among them.
TriangleMesh random_mesh(std::uint32_t seed);

// The corner positions of every triangle: what a format without indices keeps.
std::vector<std::array<double, 9>> corner_positions(const TriangleMesh& mesh);

}  // namespace cagewright::host

#endif
