// SPDX-License-Identifier: BSD-3-Clause
#include "core/refine/trust_region.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>

#include "core/mesh/tolerance.h"
#include "core/refine/vertex_step.h"

namespace cagewright {
namespace {

constexpr double raise = 10;
constexpr int attempts = 12;   // then the vertices that are still objected to stay where they are
constexpr double stay = 1e30;  // a damping under which no step is left

// A triangle and the centre that has to see it from inside.
struct Facet {
  std::array<int, 3> corners;  // counter-clockwise as seen from outside
  Vector3 center;
};

// The triangles of the cage, and those of every section as the two parts at it see them.
std::vector<Facet> facets_of(const Segmentation& segmentation, const Cage& cage) {
  std::vector<Facet> facets;
  for (Eigen::Index t = 0; t < cage.triangles.rows(); ++t) {
    const auto part = static_cast<std::size_t>(cage.triangle_part[static_cast<std::size_t>(t)]);
    facets.push_back({{cage.triangles(t, 0), cage.triangles(t, 1), cage.triangles(t, 2)}, cage.part_center[part]});
  }
  for (std::size_t k = 0; k < segmentation.slide_parts.size(); ++k) {
    const int first = static_cast<int>(4 * k);
    const Vector3& behind = cage.part_center[static_cast<std::size_t>(segmentation.slide_parts[k][0])];
    const Vector3& ahead = cage.part_center[static_cast<std::size_t>(segmentation.slide_parts[k][1])];
    for (const int i : {1, 2}) {
      facets.push_back({{first, first + i, first + i + 1}, behind});
      facets.push_back({{first, first + i + 1, first + i}, ahead});
    }
  }
  return facets;
}

// How far the centre lies behind the facet's plane, over the distance to its farthest corner: the sine of the angle
// under which that corner's ray meets the plane.
double facing(const Facet& facet, const Points& points) {
  const Vector3 a = Vector3(points.row(facet.corners[0])) - facet.center;
  const Vector3 b = Vector3(points.row(facet.corners[1])) - facet.center;
  const Vector3 c = Vector3(points.row(facet.corners[2])) - facet.center;
  const Vector3 normal = (b - a).cross(c - a).stableNormalized();
  return normal.dot(a) / std::max({a.norm(), b.norm(), c.norm()});
}

bool trusts(double facing_before, double facing_after) {
  return facing_after >=
         std::min(facing_before, std::max(tolerance::kept_facing * facing_before, tolerance::least_facing));
}

}  // namespace

void trusted_step(const Segmentation& segmentation, const Cage& cage, const std::vector<double>& factors,
                  double damping, double smallest_distance, RefineRecord& record) {
  const std::vector<Facet> facets = facets_of(segmentation, cage);
  std::vector<double> vertex_damping(static_cast<std::size_t>(record.before.rows()), damping);
  for (int attempt = 0;; ++attempt) {
    step_vertices(cage.triangles, factors, vertex_damping, smallest_distance, record);
    std::vector<bool> objected(vertex_damping.size(), false);
    for (const Facet& facet : facets) {
      if (trusts(facing(facet, record.before), facing(facet, record.after))) continue;
      for (const int corner : facet.corners) objected[static_cast<std::size_t>(corner)] = true;
    }
    if (std::find(objected.begin(), objected.end(), true) == objected.end()) return;
    for (std::size_t j = 0; j < vertex_damping.size(); ++j)
      if (objected[j]) vertex_damping[j] = attempt < attempts ? raise * vertex_damping[j] : stay;
  }
}

}  // namespace cagewright
