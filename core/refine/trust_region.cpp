// SPDX-License-Identifier: BSD-3-Clause
#include "core/refine/trust_region.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "core/refine/vertex_step.h"

namespace cagewright {
namespace {

constexpr double least_share = 0.5;  // of the sine under which the centre sees a triangle, kept by one step
constexpr double raise = 10;
constexpr int attempts = 100;  // objections wander from triangle to triangle before all are met

// How far the centre lies behind the triangle's plane, over the distance to its farthest corner: the sine of the angle
// under which that corner's ray meets the plane.
double facing(const Cage& cage, Eigen::Index t, const Points& points) {
  const Vector3 center = cage.part_center[static_cast<std::size_t>(cage.triangle_part[static_cast<std::size_t>(t)])];
  const Vector3 a = Vector3(points.row(cage.triangles(t, 0))) - center;
  const Vector3 b = Vector3(points.row(cage.triangles(t, 1))) - center;
  const Vector3 c = Vector3(points.row(cage.triangles(t, 2))) - center;
  const Vector3 normal = (b - a).cross(c - a).stableNormalized();
  return normal.dot(a) / std::max({a.norm(), b.norm(), c.norm()});
}

}  // namespace

void trusted_step(const Cage& cage, const std::vector<double>& factors, double damping, double smallest_distance,
                  RefineRecord& record) {
  std::vector<double> vertex_damping(static_cast<std::size_t>(record.before.rows()), damping);
  for (int attempt = 0; attempt < attempts; ++attempt) {
    step_vertices(cage.triangles, factors, vertex_damping, smallest_distance, record);
    std::vector<bool> objected(vertex_damping.size(), false);
    bool any = false;
    for (Eigen::Index t = 0; t < cage.triangles.rows(); ++t) {
      if (facing(cage, t, record.after) >= least_share * facing(cage, t, record.before)) continue;
      any = true;
      for (int i = 0; i < 3; ++i) objected[static_cast<std::size_t>(cage.triangles(t, i))] = true;
    }
    if (!any) return;
    for (std::size_t j = 0; j < vertex_damping.size(); ++j)
      if (objected[j]) vertex_damping[j] *= raise;
  }
}

}  // namespace cagewright
