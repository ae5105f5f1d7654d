// SPDX-License-Identifier: BSD-3-Clause
#include "core/enclose/push_out.h"

#include <Eigen/Geometry>

#include "core/enclose/triangle_distance.h"
#include "core/error/error.h"
#include "core/mesh/tolerance.h"
#include "core/refine/trust_region.h"

namespace cagewright {
namespace {

constexpr double push = 8;  // weight in (8) of the triangles that have to move, as in the refinement

struct Pushes {
  RefineRecord record;
  std::vector<double> factors;
  bool any = false;
};

Pushes find_pushes(const MovableCage& movable, const Points& plane_normals, double beyond) {
  Pushes pushes;
  const int count = movable.triangle_count();
  RefineRecord& record = pushes.record;
  record.before = movable.points();
  record.plane_normal = plane_normals;
  record.normals.resize(count, 3);
  record.anchors.resize(count, 3);
  pushes.factors.assign(static_cast<std::size_t>(count), 1.0);
  for (int t = 0; t < count; ++t) {
    const Triangle3 corners = movable.triangle(t);
    const Vector3 normal = movable.normal(t);
    const Vector3 barycenter = (corners[0] + corners[1] + corners[2]) / 3;
    Vector3 anchor = barycenter;  // (7b)
    double farthest = 0;          // by which the plane has to move
    bool is_hit = false;
    const auto offer = [&](double shift, const Vector3& where) {
      if (shift <= farthest) return;
      farthest = shift;
      anchor = where;
    };
    movable.visit_hits(t, MovableCage::Whose::own, [&](const Triangle3& hit) {
      is_hit = true;
      for (const Vector3& p : hit) offer(normal.dot(p - corners[0]) + beyond, p + beyond * normal);  // (7a)
      const double nearness = beyond - triangle_distance(hit, corners);  // at the triangle's border, behind its plane
      offer(nearness, barycenter + nearness * normal);
      return false;
    });
    record.normals.row(t) = normal.transpose();
    record.anchors.row(t) = anchor.transpose();
    if (is_hit) pushes.factors[static_cast<std::size_t>(t)] = push;
    pushes.any = pushes.any || is_hit;
  }
  return pushes;
}

}  // namespace

int push_out(MovableCage& movable, const Segmentation& segmentation, const Cage& cage, const Points& plane_normals,
             double diagonal, const EncloseOptions& options, int most, const Progress& progress) {
  Cage moving = cage;
  for (int step = 0; step < most; ++step) {
    if (progress && !progress(static_cast<double>(step) / most))
      throw Error(ErrorCode::cancelled, "cancelled while the cage was pushed out");
    // A little farther every time, as (8) is a compromise.
    const double beyond = (options.delta + tolerance::push_margin * (1 + step)) * diagonal;
    Pushes pushes = find_pushes(movable, plane_normals, beyond);
    if (!pushes.any) return step;
    moving.points = movable.points();
    trusted_step(segmentation, moving, pushes.factors, options.damping, tolerance::smallest_anchor_distance * diagonal,
                 pushes.record);
    movable.place_all(pushes.record.after);
  }
  return most;
}

}  // namespace cagewright
