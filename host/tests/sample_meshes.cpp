// SPDX-License-Identifier: BSD-3-Clause
#include "host/tests/sample_meshes.h"

#include <cmath>
#include <random>

namespace cagewright::host {

TriangleMesh unit_cube() {
  return {{0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 0, 1, 1, 0, 1, 0, 1, 1, 1, 1, 1},
          {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4, 2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5}};
}

TriangleMesh random_mesh(std::uint32_t seed) {
  std::mt19937 engine(seed);
  const auto random = [&engine] { return static_cast<std::uint32_t>(engine()); };
  TriangleMesh mesh;
  const std::uint32_t vertices = 3 + random() % 40;
  for (std::uint32_t i = 0; i < 3 * vertices; ++i) {
    const double mantissa = std::uniform_real_distribution<double>(-1, 1)(engine);
    mesh.points.push_back(std::ldexp(mantissa, static_cast<int>(random() % 200) - 100));
  }
  const std::uint32_t triangles = 1 + random() % 60;
  for (std::uint32_t i = 0; i < 3 * triangles; ++i) mesh.triangles.push_back(random() % vertices);
  return mesh;
}

std::vector<std::array<double, 9>> corner_positions(const TriangleMesh& mesh) {
  std::vector<std::array<double, 9>> result(mesh.triangle_count());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      result[i / 3][3 * (i % 3) + k] = mesh.points[3 * std::size_t{mesh.triangles[i]} + k];
    }
  }
  return result;
}

}  // namespace cagewright::host
