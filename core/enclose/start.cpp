// SPDX-License-Identifier: BSD-3-Clause
#include "core/enclose/start.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

namespace cagewright {
namespace {

constexpr double stride = 0.25, farthest = 2;  // levels: 0 where it is, 1 round the loop, 2 near the slide's centre
constexpr double kept_section = 0.3, kept_cap = 0.8, kept_end = 0.25;  // of a size

// The four corners of a section or a cap at the three levels.
struct Ring {
  std::array<int, 4> vertices;
  std::array<std::array<Vector3, 4>, 3> at;
  double level = 0;
};

std::array<Vector3, 4> about(const Vector3& center, const std::array<Vector3, 4>& corners, double scale) {
  std::array<Vector3, 4> scaled;
  for (std::size_t i = 0; i < 4; ++i) scaled[i] = center + scale * (corners[i] - center);
  return scaled;
}

std::array<Vector3, 4> rectangle_round(const Points& loop, const SectionFrame& section, double margin) {
  const Vector3 p = section.p.normalized(), q = section.q.normalized();
  double low_p = 0, low_q = 0, high_p = 0, high_q = 0;
  for (Eigen::Index i = 0; i < loop.rows(); ++i) {
    const Vector3 d = loop.row(i).transpose() - section.center;
    low_p = std::min(low_p, p.dot(d));
    high_p = std::max(high_p, p.dot(d));
    low_q = std::min(low_q, q.dot(d));
    high_q = std::max(high_q, q.dot(d));
  }
  const auto corner = [&](double a, double b) -> Vector3 { return section.center + a * p + b * q; };
  low_p -= margin;
  low_q -= margin;
  high_p += margin;
  high_q += margin;
  return {corner(high_p, high_q), corner(low_p, high_q), corner(low_p, low_q), corner(high_p, low_q)};
}

std::vector<Ring> find_rings(const MovableCage& movable, const std::vector<SectionFrame>& sections, double margin) {
  const Segmentation& segmentation = movable.segmentation();
  std::vector<Ring> rings;
  for (std::size_t k = 0; k < sections.size(); ++k) {
    Ring ring;
    for (int i = 0; i < 4; ++i) {
      ring.vertices[static_cast<std::size_t>(i)] = static_cast<int>(4 * k) + i;
      ring.at[0][static_cast<std::size_t>(i)] = movable.point(static_cast<int>(4 * k) + i);
    }
    ring.at[1] = rectangle_round(segmentation.loops[k], sections[k], margin);
    ring.at[2] = about(sections[k].center, ring.at[1], kept_section);
    rings.push_back(ring);
  }
  const Cage& cage = movable.cage();
  std::vector<int> part_of(static_cast<std::size_t>(movable.vertex_count()), -1);
  for (int t = 0; t < movable.triangle_count(); ++t)
    for (int i = 0; i < 3; ++i)
      part_of[static_cast<std::size_t>(movable.vertex_of(t, i))] = cage.triangle_part[static_cast<std::size_t>(t)];
  // Caps come four corners each, but for boxes, of parts without sections.
  for (int v = static_cast<int>(4 * sections.size()); v + 3 < movable.vertex_count(); v += 4) {
    if (part_of[static_cast<std::size_t>(v)] < 0) continue;  // of no triangle
    const auto part = static_cast<std::size_t>(part_of[static_cast<std::size_t>(v)]);
    const std::vector<PartSection>& bounds = segmentation.parts[part].sections;
    if (bounds.empty()) continue;
    Ring ring;
    Vector3 middle = Vector3::Zero();
    for (int i = 0; i < 4; ++i) {
      const auto corner = static_cast<std::size_t>(i);
      ring.vertices[corner] = v + i;
      ring.at[0][corner] = movable.point(v + i);
      middle += ring.at[0][corner] / 4;
    }
    const Vector3 from =
        bounds.size() == 1 ? sections[static_cast<std::size_t>(bounds[0].slide)].center : cage.part_center[part];
    ring.at[1] = about(middle, ring.at[0], kept_cap);
    ring.at[2] = about(middle, ring.at[0], kept_end);
    for (Vector3& corner : ring.at[2]) corner += 0.3 * (from - middle);
    rings.push_back(ring);
  }
  return rings;
}

Vector3 corner_at(const Ring& ring, std::size_t i, double level) {
  const auto lower = std::min<std::size_t>(1, static_cast<std::size_t>(level));
  const double share = level - static_cast<double>(lower);
  return ring.at[lower][i] + share * (ring.at[lower + 1][i] - ring.at[lower][i]);
}

}  // namespace

bool draw_back(MovableCage& movable, const SectionShape& shape, const std::vector<SectionFrame>& sections,
               const Guard& guard, double margin) {
  Points points = movable.points();
  shape.put_in_shape(points);
  movable.place_all(points);
  std::vector<Ring> rings = find_rings(movable, sections, margin);
  std::vector<int> ring_of(static_cast<std::size_t>(movable.vertex_count()), -1);
  for (std::size_t r = 0; r < rings.size(); ++r)
    for (const int v : rings[r].vertices) ring_of[static_cast<std::size_t>(v)] = static_cast<int>(r);
  for (;;) {
    const std::vector<char> objections = find_objections(movable, guard);
    std::vector<char> drawn(rings.size(), 0);
    bool is_clear = true, any = false;
    for (std::size_t t = 0; t < objections.size(); ++t) {
      if (!objections[t]) continue;
      is_clear = false;
      for (int i = 0; i < 3; ++i) {
        const int r = ring_of[static_cast<std::size_t>(movable.vertex_of(static_cast<int>(t), i))];
        if (r < 0 || drawn[static_cast<std::size_t>(r)] || rings[static_cast<std::size_t>(r)].level >= farthest)
          continue;
        drawn[static_cast<std::size_t>(r)] = 1;
        rings[static_cast<std::size_t>(r)].level += stride;
        any = true;
      }
    }
    if (is_clear || !any) return is_clear;
    for (std::size_t r = 0; r < rings.size(); ++r) {
      if (!drawn[r]) continue;
      for (std::size_t i = 0; i < 4; ++i)
        points.row(rings[r].vertices[i]) = corner_at(rings[r], i, rings[r].level).transpose();
    }
    shape.put_in_shape(points);
    movable.place_all(points);
  }
}

}  // namespace cagewright
