// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <limits>

#include "host/validate/refinement_checks.h"

namespace cagewright::host {
namespace {

constexpr double clearly =
    1e-7;  // sine by which a ray has to pass within a triangle to be seen through it beyond doubt

// The rays from a part's centre through one triangle of the cage.
struct Cone {
  std::size_t triangle;
  std::array<Eigen::Vector3d, 3> sides;  // unit, inward

  // The sine of the least angle to a side, times the ray's length over `size`; negative outside.
  double margin(const Eigen::Vector3d& ray) const {
    return std::min({sides[0].dot(ray), sides[1].dot(ray), sides[2].dot(ray)});
  }
};

Cone cone_of(const Eigen::Vector3d& center, const PointList& points, const Corners& corners, std::size_t triangle) {
  Cone cone{triangle, {}};
  for (std::size_t i = 0; i < 3; ++i) {
    const Eigen::Vector3d a = points[static_cast<std::size_t>(corners[i])] - center;
    const Eigen::Vector3d b = points[static_cast<std::size_t>(corners[(i + 1) % 3])] - center;
    cone.sides[i] = a.cross(b).stableNormalized();
  }
  return cone;
}

class Outermost {
 public:
  Outermost(const ObservedCage& seen, const ObservedIteration& iteration) : seen_(seen), iteration_(iteration) {
    cones_.resize(seen.parts.size());
    for (std::size_t t = 0; t < seen.triangles.size(); ++t) {
      const auto part = static_cast<std::size_t>(seen.triangle_part[t]);
      cones_[part].push_back(cone_of(seen.parts[part].center, iteration.before, seen.triangles[t], t));
    }
  }

  // Tells for every vertex of every part each triangle that surely has to clear it.
  template <class Tell>
  void for_each_duty(Tell tell) const {
    for (std::size_t p = 0; p < seen_.parts.size(); ++p) {
      if (seen_.parts[p].is_enclosed) continue;  // any part's cage may bound it
      for (const int v : seen_.parts[p].vertices) {
        if (!seen_.is_local) {
          for (const Cone& cone : cones_[p]) tell(v, cone.triangle);
        } else if (const Cone* only = only_cone(p, v)) {
          tell(v, only->triangle);
        }
      }
    }
  }

  // How far the vertex that triangle t names is from being seen through it, over its distance from the centre: 0 where
  // it is, where the part's cones hold it nowhere, or where it is not the part's own.
  double stray(std::size_t t) const {
    const auto part = static_cast<std::size_t>(seen_.triangle_part[t]);
    const Eigen::Vector3d& v = seen_.model[static_cast<std::size_t>(iteration_.outermost[t])];
    const Eigen::Vector3d ray = v - seen_.parts[part].center;
    double own = 0, best = -std::numeric_limits<double>::infinity();
    for (const Cone& cone : cones_[part]) {
      const double margin = cone.margin(ray);
      if (cone.triangle == t) own = margin;
      best = std::max(best, margin);
    }
    const double length = std::max(ray.norm(), 1e-3 * seen_.extent);
    return best >= clearly * length ? std::max(0.0, -own / length) : 0;
  }

 private:
  const Cone* only_cone(std::size_t part, int v) const {
    const Eigen::Vector3d ray = seen_.model[static_cast<std::size_t>(v)] - seen_.parts[part].center;
    const Cone* found = nullptr;
    for (const Cone& cone : cones_[part]) {
      const double margin = cone.margin(ray);
      if (margin < -clearly * seen_.extent) continue;
      if (found != nullptr || margin < clearly * seen_.extent) return nullptr;  // more than one may have it
      found = &cone;
    }
    return found;
  }

  const ObservedCage& seen_;
  const ObservedIteration& iteration_;
  std::vector<std::vector<Cone>> cones_;
};

}  // namespace

void check_outermost(const ObservedCage& seen, const ObservedIteration& iteration, const std::string& where,
                     Check& missed, Check& stray) {
  const Outermost outermost(seen, iteration);
  PointList barycenters, normals;
  for (const Corners& t : seen.triangles) {
    const Eigen::Vector3d &a = iteration.before[static_cast<std::size_t>(t[0])],
                          &b = iteration.before[static_cast<std::size_t>(t[1])],
                          &c = iteration.before[static_cast<std::size_t>(t[2])];
    barycenters.push_back((a + b + c) / 3);
    normals.push_back((b - a).cross(c - a).stableNormalized());
  }
  outermost.for_each_duty([&](int v, std::size_t t) {
    const double d = (seen.model[static_cast<std::size_t>(v)] - barycenters[t]).dot(normals[t]);
    const double beyond = (d - iteration.signed_distances[t]) / seen.diagonal;
    missed.offer(std::max(0.0, beyond - seen.extent / seen.diagonal * 1e-9), [&] {
      return where + ", triangle " + std::to_string(t) + " of the cage: vertex " + std::to_string(v) +
             " of the cut model is " + text_of(beyond) +
             " of the diagonal farther out than the one of (6) that is named";
    });
  });
  if (!seen.is_local) return;
  for (std::size_t t = 0; t < seen.triangles.size(); ++t) {
    if (iteration.outermost[t] < 0) continue;
    const double off = outermost.stray(t);
    stray.offer(off, [&] {
      return where + ", triangle " + std::to_string(t) + " of the cage: vertex " +
             std::to_string(iteration.outermost[t]) +
             " of the cut model, which it names as its outermost, is seen "
             "through another triangle";
    });
  }
}

}  // namespace cagewright::host
