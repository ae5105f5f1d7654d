// SPDX-License-Identifier: BSD-3-Clause
#include "core/measure/surface_samples.h"

#include <Eigen/Geometry>
#include <numeric>

namespace cagewright {
namespace {

constexpr std::size_t most_rows = 12;

std::size_t points_of(std::size_t rows) { return rows * (rows + 1) / 2; }

double doubled_area(const IndexedMesh& mesh, Eigen::Index t) {
  const auto corners = mesh.triangles.row(t);
  const Vector3 a = mesh.points.row(corners(0)), b = mesh.points.row(corners(1)), c = mesh.points.row(corners(2));
  return (b - a).cross(c - a).norm();
}

}  // namespace

SurfaceSamples::SurfaceSamples(const IndexedMesh& mesh, std::size_t most) : mesh_(mesh) {
  const std::size_t count = static_cast<std::size_t>(mesh.triangles.rows());
  std::size_t rows = most_rows;
  while (rows > 1 && points_of(rows) * count > most) --rows;
  if (rows == 1) stride_ = (count + most - 1) / most;

  for (std::size_t i = 0; i < rows; ++i)
    for (std::size_t j = 0; i + j < rows; ++j) {
      const double n = static_cast<double>(rows);
      const double u = (static_cast<double>(i) + 1.0 / 3) / n, v = (static_cast<double>(j) + 1.0 / 3) / n;
      weights_.emplace_back(1 - u - v, u, v);
    }
  shares_.resize((count + stride_ - 1) / stride_);
  for (std::size_t t = 0; t < shares_.size(); ++t) shares_[t] = doubled_area(mesh, row(t));
  const double area = std::accumulate(shares_.begin(), shares_.end(), 0.0);
  for (double& share : shares_) share = area > 0 ? share / area : 1 / static_cast<double>(shares_.size());
}

}  // namespace cagewright
