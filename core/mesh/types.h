// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>

namespace cagewright {

using Vector2 = Eigen::Vector2d;
using Vector3 = Eigen::Vector3d;
using Points = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;  // n x 3, row = vertex, model units
using Triangles = Eigen::Matrix<int, Eigen::Dynamic, 3, Eigen::RowMajor>;  // m x 3, row = triangle, vertex rows

// Triangles as they come: nothing is promised about closedness or manifoldness.
struct IndexedMesh {
  Points points;
  Triangles triangles;
};

}  // namespace cagewright
