// SPDX-License-Identifier: BSD-3-Clause
#include "core/measure/measured_model.h"

#include <Eigen/Geometry>
#include <cmath>

#include "core/mesh/volume.h"

namespace cagewright {

double signed_volume(const IndexedMesh& mesh) {
  const Labels one_component{std::vector<int>(static_cast<std::size_t>(mesh.triangles.rows()), 0), 1};
  return find_volumes(mesh, one_component).in_model_units();
}

IndexedMesh MeasuredModel::to_units(const IndexedMesh& mesh) const {
  return {(mesh.points.rowwise() - center_.transpose()) / diagonal_, mesh.triangles};
}

MeasuredModel::MeasuredModel(const IndexedMesh& model, unsigned threads)
    : center_(0.5 * model.points.colwise().minCoeff() + 0.5 * model.points.colwise().maxCoeff()),
      diagonal_((model.points.colwise().maxCoeff() - model.points.colwise().minCoeff()).stableNorm()),
      mesh_(to_units(model)),
      surface_(mesh_, threads),
      volume_(std::abs(signed_volume(mesh_))),
      vertex_shares_(static_cast<std::size_t>(model.points.rows()), 0) {
  double area = 0;
  Vector3 first = Vector3::Zero();
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
  for (Eigen::Index t = 0; t < mesh_.triangles.rows(); ++t) {
    const auto corners = mesh_.triangles.row(t);
    const Vector3 a = mesh_.points.row(corners(0)), b = mesh_.points.row(corners(1)), c = mesh_.points.row(corners(2));
    const double own = (b - a).cross(c - a).norm() / 2;
    const Vector3 sum = a + b + c;
    area += own;
    first += own / 3 * sum;
    second += own / 12 * (a * a.transpose() + b * b.transpose() + c * c.transpose() + sum * sum.transpose());
    for (const int v : corners) vertex_shares_[static_cast<std::size_t>(v)] += own / 3;
  }
  for (double& share : vertex_shares_) share /= area;
  centroid_ = first / area;
  covariance_ = second / area - centroid_ * centroid_.transpose();
}

}  // namespace cagewright
