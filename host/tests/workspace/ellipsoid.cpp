// SPDX-License-Identifier: BSD-3-Clause
#include "host/tests/workspace/ellipsoid.h"

#include <cmath>
#include <numbers>

namespace cagewright::host::test {

TriangleMesh ellipsoid(std::uint32_t rows, std::uint32_t columns) {
  using std::numbers::pi;
  TriangleMesh mesh;
  mesh.points = {0, -2, 0};
  for (std::uint32_t i = 1; i < rows; ++i) {
    const double down = pi * i / rows;
    for (std::uint32_t j = 0; j < columns; ++j) {
      const double round = 2 * pi * j / columns;
      mesh.points.insert(mesh.points.end(), {0.5 * std::sin(down) * std::cos(round), -2 * std::cos(down),
                                             0.4 * std::sin(down) * std::sin(round)});
    }
  }
  mesh.points.insert(mesh.points.end(), {0, 2, 0});
  const auto last = static_cast<std::uint32_t>(mesh.vertex_count() - 1);
  const auto at = [&](std::uint32_t row, std::uint32_t column) { return 1 + (row - 1) * columns + column % columns; };
  for (std::uint32_t j = 0; j < columns; ++j) {
    mesh.triangles.insert(mesh.triangles.end(), {0, at(1, j), at(1, j + 1)});
    for (std::uint32_t i = 1; i + 1 < rows; ++i) {
      mesh.triangles.insert(mesh.triangles.end(), {at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.insert(mesh.triangles.end(), {at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
    mesh.triangles.insert(mesh.triangles.end(), {at(rows - 1, j), last, at(rows - 1, j + 1)});
  }
  return mesh;
}

}  // namespace cagewright::host::test
