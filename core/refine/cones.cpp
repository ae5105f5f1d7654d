// SPDX-License-Identifier: BSD-3-Clause
#include "core/refine/cones.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "core/meshing/bound.h"

namespace cagewright {
namespace {

constexpr int none = -2;

// The unit normal of the plane through the centre and the edge from a to b; positive on the left as seen from outside.
Vector3 plane_through(const Vector3& center, const Vector3& a, const Vector3& b) {
  return (a - center).cross(b - center).stableNormalized();
}

template <std::size_t n>
double margin(const std::array<Vector3, n>& planes, const Vector3& ray) {
  double least = planes[0].dot(ray);
  for (std::size_t i = 1; i < n; ++i) least = std::min(least, planes[i].dot(ray));
  return least;
}

}  // namespace

Cones::Cones(const Segmentation& segmentation, const Cage& topology, const Points& points, double on_plane)
    : on_plane_(on_plane), parts_(segmentation.parts.size()) {
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    parts_[p].center = topology.part_center[p];
    for (const PartSection& side : segmentation.parts[p].sections)
      parts_[p].openings.push_back(
          opening_of(side, segmentation.slide_parts[static_cast<std::size_t>(side.slide)], parts_[p].center, points));
  }
  for (Eigen::Index t = 0; t < topology.triangles.rows(); ++t) {
    Part& part = parts_[static_cast<std::size_t>(topology.triangle_part[static_cast<std::size_t>(t)])];
    slot_.push_back(static_cast<int>(part.walls.size()));
    Wall wall{static_cast<int>(t), {}};
    for (int i = 0; i < 3; ++i)
      wall.planes[static_cast<std::size_t>(i)] = plane_through(part.center, points.row(topology.triangles(t, i)),
                                                               points.row(topology.triangles(t, (i + 1) % 3)));
    part.walls.push_back(wall);
  }
}

Cones::Opening Cones::opening_of(const PartSection& side, const std::array<int, 2>& slide_parts, const Vector3& center,
                                 const Points& points) const {
  Opening opening;
  opening.behind = slide_parts[side.outward ? 1 : 0];
  for (int i = 0; i < 4; ++i) {
    const int corner = corner_as_seen(side.outward, i);
    opening.corners[static_cast<std::size_t>(i)] = points.row(4 * side.slide + corner);
  }
  const auto& c = opening.corners;
  for (std::size_t i = 0; i < 4; ++i) opening.planes[i] = plane_through(center, c[i], c[(i + 1) % 4]);
  opening.normals = {plane_through(c[0], c[1], c[2]), plane_through(c[0], c[2], c[3])};
  return opening;
}

bool Cones::sees(int part, int t, const Vector3& v) const {
  const Part& p = parts_[static_cast<std::size_t>(part)];
  const auto slot = static_cast<std::size_t>(slot_[static_cast<std::size_t>(t)]);
  return slot < p.walls.size() && p.walls[slot].triangle == t &&
         margin(p.walls[slot].planes, v - p.center) >= -on_plane_;
}

int Cones::wall_of(const Part& part, const Vector3& v) const {
  const Vector3 ray = v - part.center;
  for (const Wall& wall : part.walls)
    if (margin(wall.planes, ray) >= -on_plane_) return wall.triangle;
  return none;
}

const Cones::Opening* Cones::opening_of(const Part& part, const Vector3& v) const {
  const Vector3 ray = v - part.center;
  const auto found = std::find_if(part.openings.begin(), part.openings.end(),
                                  [&](const Opening& opening) { return margin(opening.planes, ray) >= -on_plane_; });
  return found == part.openings.end() ? nullptr : &*found;
}

// A section that was refined freely is no longer flat: in front of either of its triangles counts.
bool Cones::in_front(const Opening& opening, const Vector3& v) const {
  const Vector3 from_corner = v - opening.corners[0];
  return std::min(opening.normals[0].dot(from_corner), opening.normals[1].dot(from_corner)) <= on_plane_;
}

int Cones::triangle_of(int part, const Vector3& v) const {
  const Part& here = parts_[static_cast<std::size_t>(part)];
  if (const int wall = wall_of(here, v); wall != none) return wall;
  if (const Opening* opening = opening_of(here, v)) {
    if (in_front(*opening, v)) return inside;
    const Part& behind = parts_[static_cast<std::size_t>(opening->behind)];
    if (const int wall = wall_of(behind, v); wall != none) return wall;
    if (const Opening* other = opening_of(behind, v); other && in_front(*other, v)) return inside;
  }
  int nearest = inside;
  double best = -std::numeric_limits<double>::infinity();
  for (const Wall& wall : here.walls) {
    const double m = margin(wall.planes, v - here.center);
    if (m <= best + on_plane_) continue;
    best = m;
    nearest = wall.triangle;
  }
  return nearest;
}

}  // namespace cagewright
