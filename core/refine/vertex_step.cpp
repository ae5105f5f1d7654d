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

Vector3 free_step(const Quadratic& q, double mu) { return (q.a + mu * Eigen::Matrix3d::Identity()).ldlt().solve(q.b); }

Vector3 step_in_plane(const Quadratic& q, double mu, const Vector3& normal) {
  Eigen::Matrix<double, 3, 2> basis;
  basis.col(0) = normal.unitOrthogonal();
  basis.col(1) = normal.cross(basis.col(0));
  const Eigen::Matrix2d a = basis.transpose() * q.a * basis + mu * Eigen::Matrix2d::Identity();
  return basis * a.ldlt().solve(basis.transpose() * q.b);
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
    const double mu = damping[j] * q.a.trace();
    record.damping[j] = mu;
    if (!(mu > 0)) continue;  // a vertex of no triangle with an area stays
    const auto row = static_cast<Eigen::Index>(j);
    const Vector3 normal = record.plane_normal.row(row);
    const Vector3 step = normal.isZero() ? free_step(q, mu) : step_in_plane(q, mu, normal);
    record.after.row(row) += step.transpose();
  }
}

}  // namespace cagewright
