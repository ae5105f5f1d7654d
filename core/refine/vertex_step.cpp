// SPDX-License-Identifier: BSD-3-Clause
#include "core/refine/vertex_step.h"

#include <Eigen/Dense>
#include <algorithm>

namespace cagewright {
namespace {

// The quadratic form of one vertex, in the step s = x - u_j: s.A s - 2 b.s.
struct Quadratic {
  Eigen::Matrix3d a = Eigen::Matrix3d::Zero();
  Vector3 b = Vector3::Zero();
};

// Columns: the directions in which a vertex may move.
using Directions = Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::ColMajor, 3, 3>;
using SmallMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, 3, 3>;

Directions free_directions(const Vector3& plane_normal) {
  if (plane_normal.isZero()) return Eigen::Matrix3d::Identity();
  Directions directions(3, 2);
  directions.col(0) = plane_normal.unitOrthogonal();
  directions.col(1) = plane_normal.cross(directions.col(0));
  return directions;
}

}  // namespace

void step_vertices(const Triangles& triangles, const std::vector<double>& factors, const std::vector<double>& damping,
                   double smallest_distance, RefineRecord& record) {
  std::vector<Quadratic> quadratics(static_cast<std::size_t>(record.before.rows()));
  record.weights.resize(triangles.rows(), 3);
  for (Eigen::Index t = 0; t < triangles.rows(); ++t) {
    const Vector3 n = record.normals.row(t), a = record.anchors.row(t);
    for (int i = 0; i < 3; ++i) {
      const Vector3 u = record.before.row(triangles(t, i));
      const double distance = std::max((u - a).norm(), smallest_distance);
      const double w = factors[static_cast<std::size_t>(t)] / (distance * distance);
      record.weights(t, i) = w;
      Quadratic& q = quadratics[static_cast<std::size_t>(triangles(t, i))];
      q.a += w * n * n.transpose();
      q.b += w * n.dot(a - u) * n;
    }
  }
  record.after = record.before;
  record.damping.assign(quadratics.size(), 0);
  for (std::size_t j = 0; j < quadratics.size(); ++j) {
    const Quadratic& q = quadratics[j];
    const auto row = static_cast<Eigen::Index>(j);
    const Directions directions = free_directions(record.plane_normal.row(row));
    SmallMatrix a = directions.transpose() * q.a * directions;
    const double mu = damping[j] * a.trace();
    record.damping[j] = mu;
    if (!(mu > 0)) continue;  // a vertex of no triangle with an area stays
    a.diagonal().array() += mu;
    record.after.row(row) += (directions * a.ldlt().solve(directions.transpose() * q.b)).transpose();
  }
}

}  // namespace cagewright
