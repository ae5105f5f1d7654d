// SPDX-License-Identifier: BSD-3-Clause
// Hildreth, A quadratic programming procedure, 1957: one condition after the other, by its force.
#include "core/enclose/offset_walls.h"

#include <algorithm>

namespace cagewright {
namespace {

constexpr int sweeps = 60;
constexpr double longest = 2.5;      // of a step, over the distance
constexpr double least_give = 0.04;  // squared share of a normal that lies in the plane of the vertex

}  // namespace

Points offset_walls(const MovableCage& movable, const Points& plane_normals, double distance) {
  Points steps = Points::Zero(movable.vertex_count(), 3);
  for (int v = 0; v < movable.vertex_count(); ++v) {
    const Vector3 plane = plane_normals.row(v);
    std::vector<Vector3> normals;
    for (const int t : movable.triangles_at(v)) {
      const Vector3 n = movable.normal(t), across = n - plane * plane.dot(n);
      if (across.squaredNorm() > least_give) normals.push_back(across);
    }
    std::vector<double> force(normals.size(), 0);
    Vector3 step = Vector3::Zero();
    for (int sweep = 0; sweep < sweeps; ++sweep)
      for (std::size_t i = 0; i < normals.size(); ++i) {
        const double lacking = (distance - normals[i].dot(step)) / normals[i].squaredNorm();
        const double change = std::max(lacking, -force[i]);
        force[i] += change;
        step += change * normals[i];
      }
    if (const double length = step.norm(); length > longest * distance) step *= longest * distance / length;
    steps.row(v) = step.transpose();
  }
  return steps;
}

}  // namespace cagewright
