// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/mesh/types.h"

namespace cagewright {

// Fixed points on the surface of a mesh: no random numbers. The edges of a triangle are cut into `rows` equal pieces,
// so that it falls into rows^2 congruent ones; the points are the barycentres of those rows (rows + 1) / 2 that are not
// upside down. Each triangle counts by its area. 12 rows (78 points) where that makes no more than `most` points;
// otherwise as many rows as fit, and where not even barycentres fit, those of every so manieth triangle.
class SurfaceSamples {
 public:
  // Borrows the mesh. Precondition: at least one triangle; most > 0. O(n).
  SurfaceSamples(const IndexedMesh& mesh, std::size_t most);

  std::size_t triangles() const { return shares_.size(); }  // that have points
  std::size_t points_each() const { return weights_.size(); }
  Eigen::Index row(std::size_t triangle) const { return static_cast<Eigen::Index>(triangle * stride_); }
  double share(std::size_t triangle) const { return shares_[triangle]; }  // of the area of those; the sum is 1
  Vector3 point(std::size_t triangle, std::size_t k) const {
    const auto corners = mesh_.triangles.row(row(triangle));
    return weights_[k][0] * mesh_.points.row(corners(0)) + weights_[k][1] * mesh_.points.row(corners(1)) +
           weights_[k][2] * mesh_.points.row(corners(2));
  }

 private:
  const IndexedMesh& mesh_;
  std::size_t stride_ = 1;
  std::vector<Vector3> weights_;  // barycentric
  std::vector<double> shares_;
};

}  // namespace cagewright
