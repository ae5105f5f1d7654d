// SPDX-License-Identifier: BSD-3-Clause
#include "core/tests/clicks.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace cagewright {

double angle_between_lines(const Vector3& a, const Vector3& b) {
  return std::atan2(a.cross(b).norm(), std::abs(a.dot(b)));
}

Vector3 random_point_on(const HalfEdgeMesh& mesh, Random& random) {
  const OpenMesh::FaceHandle face(random.below(static_cast<int>(mesh.n_faces())));
  Vector3 weights(random.uniform(0.01, 1), random.uniform(0.01, 1), random.uniform(0.01, 1)), point = Vector3::Zero();
  weights /= weights.sum();
  int i = 0;
  for (const auto v : mesh.fv_range(face)) point += weights[i++] * mesh.point(v);
  return point;
}

double distance_to(const Points& loop, const Vector3& point) {
  double least = std::numeric_limits<double>::infinity();
  for (Eigen::Index i = 0; i < loop.rows(); ++i) {
    const Vector3 a = loop.row(i), edge = Vector3(loop.row((i + 1) % loop.rows())) - a;
    const double t = std::clamp(edge.dot(point - a) / std::max(edge.squaredNorm(), 1e-300), 0.0, 1.0);
    least = std::min(least, (a + t * edge - point).norm());
  }
  return least;
}

}  // namespace cagewright
