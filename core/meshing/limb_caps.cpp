// SPDX-License-Identifier: BSD-3-Clause
#include "core/meshing/limb_caps.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/mesh/tolerance.h"
#include "core/mesh/triangle.h"
#include "core/meshing/convex_hull.h"

namespace cagewright {
namespace {

double mean_half_side(const std::vector<SectionFrame>& sections) {
  double sum = 0;
  for (const SectionFrame& section : sections) sum += (section.p.norm() + section.q.norm()) / 2;
  return sum / static_cast<double>(sections.size());
}

// Of the sections: the caps have its directions.
const SectionFrame& widest(const std::vector<SectionFrame>& sections) {
  const auto area = [](const SectionFrame& section) { return section.p.norm() * section.q.norm(); };
  const SectionFrame* best = &sections.front();
  for (const SectionFrame& section : sections)
    if (area(section) > (1 + tolerance::tie) * area(*best)) best = &section;
  return *best;
}

// From the corners' plane to the one farthest behind it, for the face where that is most.
double size_of(const std::vector<HullPlane>& hull, const std::vector<Vector3>& corners) {
  double size = 0;
  for (const auto& [normal, offset] : hull)
    for (const Vector3& corner : corners) size = std::max(size, -(normal.dot(corner) + offset));
  return size;
}

struct Tip {
  Vector3 point = Vector3::Zero();
  double height = 0;  // above the plane of the hull that it is farthest above
};

// Of vertices that are as far, at the end of a flat limb, the middle: which of them comes first says nothing.
Tip tip_above(const Points& points, const Part& part, const HullPlane& plane) {
  const auto height_of = [&](int v) { return plane.normal.dot(points.row(v)) + plane.offset; };
  Tip tip;
  for (const int v : part.vertices) tip.height = std::max(tip.height, height_of(v));
  int count = 0;
  for (const int v : part.vertices) {
    if (height_of(v) < (1 - tolerance::tie) * tip.height) continue;
    tip.point += points.row(v).transpose();
    ++count;
  }
  tip.point /= count;
  return tip;
}

// Above several planes as far, the one farthest from the middle of the hull's corners.
Tip farthest_outside(const Points& points, const Part& part, const std::vector<HullPlane>& hull,
                     const std::vector<Vector3>& corners) {
  Vector3 middle = Vector3::Zero();
  for (const Vector3& corner : corners) middle += corner / static_cast<double>(corners.size());
  Tip farthest;
  double most = 0;
  for (const HullPlane& plane : hull) {
    const Tip tip = tip_above(points, part, plane);
    if (tip.height < (1 - tolerance::tie) * farthest.height) continue;
    const double distance = (tip.point - middle).norm();
    const bool is_tie = tip.height <= (1 + tolerance::tie) * farthest.height;
    if (is_tie && distance <= (1 + tolerance::tie) * most) continue;
    farthest = tip;
    most = distance;
  }
  return farthest;
}

// From the hull of the corners to a point outside it.
Vector3 away_from_hull(const std::vector<Vector3>& corners, const Vector3& point) {
  Vector3 away = Vector3::Constant(std::numeric_limits<double>::infinity());
  for (const auto& [a, b, c] : hull_triangles(corners)) {
    const auto at = [&](int i) -> const Vector3& { return corners[static_cast<std::size_t>(i)]; };
    const Triangle3 triangle{at(a), at(b), at(c)};
    const Vector3 from = point - at_barycentric(triangle, nearest_on_triangle(point, triangle));
    if (from.squaredNorm() < away.squaredNorm()) away = from;
  }
  return away;
}

// Through `tip`, across `away`, round all of the part that is not more than half of its length below.
CapCorners cap_at(const Points& points, const Part& part, const Vector3& tip, const Vector3& away,
                  const SectionFrame& along, double least_half) {
  const Vector3 out = away.normalized();
  const Vector3 p_of_section = along.p.normalized(), q_of_section = along.q.normalized();
  const bool along_p = std::abs(out.dot(p_of_section)) <= (1 + tolerance::tie) * std::abs(out.dot(q_of_section));
  const Vector3& axis = along_p ? p_of_section : q_of_section;
  const Vector3 p = (axis - axis.dot(out) * out).normalized(), q = out.cross(p);
  Eigen::AlignedBox2d box;
  for (const int v : part.vertices) {
    const Vector3 offset = Vector3(points.row(v)) - tip;
    if (out.dot(offset) >= -(0.5 + tolerance::tie) * away.norm()) box.extend(Vector2(p.dot(offset), q.dot(offset)));
  }
  const Vector2 middle = box.center(), half = (box.sizes() / 2).cwiseMax(least_half);
  const auto corner = [&](double a, double b) -> Vector3 {
    return tip + (middle.x() + a * half.x()) * p + (middle.y() + b * half.y()) * q;
  };
  return {corner(1, 1), corner(-1, 1), corner(-1, -1), corner(1, -1)};
}

}  // namespace

std::vector<CapCorners> limb_caps(const Points& points, const Part& part, std::vector<Vector3> corners,
                                  const std::vector<SectionFrame>& sections) {
  const double half_side = mean_half_side(sections);
  std::vector<CapCorners> caps;
  while (caps.size() < tolerance::most_limb_caps) {
    const std::vector<HullPlane> hull = hull_planes(corners);
    const double near =
        std::max(tolerance::far_of_sections * half_side, tolerance::far_of_hull * size_of(hull, corners));
    const Tip tip = farthest_outside(points, part, hull, corners);
    if (tip.height <= (1 + tolerance::tie) * near) break;
    const Vector3 away = away_from_hull(corners, tip.point);
    caps.push_back(cap_at(points, part, tip.point, away, widest(sections), tolerance::least_cap * half_side));
    corners.insert(corners.end(), caps.back().begin(), caps.back().end());
  }
  return caps;
}

}  // namespace cagewright
