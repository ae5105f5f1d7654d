// SPDX-License-Identifier: BSD-3-Clause
#include "core/meshing/flip.h"

#include <Eigen/Geometry>
#include <cmath>
#include <optional>

#include "core/mesh/tolerance.h"

namespace cagewright {
namespace {

class Smoothness {
 public:
  Smoothness(const SphericalTriangulation& triangulation, const std::set<Edge>& section_edges,
             const SectionNormals& normals)
      : t_(triangulation), section_edges_(section_edges), normals_(normals) {}

  bool fixed(int a, int b) const { return section_edges_.count(std::minmax(a, b)) > 0; }

  // How many radians smoother the cage is after the flip of ab: the paper's inequality, left minus right.
  double gain(int a, int b) const {
    const int c = t_.opposite(a, b), d = t_.opposite(b, a);
    const Vector3 n_i = normal(a, b, c), n_j = normal(b, a, d);
    const Vector3 m_i = normal(a, d, c), m_j = normal(d, b, c);  // n'_i, n'_j
    const Vector3 n_bc = across(b, c), n_ca = across(c, a), n_ad = across(a, d), n_db = across(d, b);
    const double before = angle(n_i, n_bc) + angle(n_i, n_ca) + angle(n_j, n_ad) + angle(n_j, n_db) + angle(n_i, n_j);
    const double after = angle(m_i, n_ca) + angle(m_i, n_ad) + angle(m_j, n_bc) + angle(m_j, n_db) + angle(m_i, m_j);
    return before - after;
  }

 private:
  static double angle(const Vector3& a, const Vector3& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }

  Vector3 across(int a, int b) const { return normal(b, a, t_.opposite(b, a)); }

  // A triangle inside a section counts with the section's outward normal.
  Vector3 normal(int a, int b, int c) const {
    const int section = normals_.section_of.at(a);
    if (section == normals_.section_of.at(b) && section == normals_.section_of.at(c))
      return normals_.outward[static_cast<std::size_t>(section)];
    const auto at = [&](int i) -> const Vector3& { return t_.points()[static_cast<std::size_t>(i)]; };
    return (at(b) - at(a)).cross(at(c) - at(a)).stableNormalized();
  }

  const SphericalTriangulation& t_;
  const std::set<Edge>& section_edges_;
  const SectionNormals& normals_;
};

struct Flip {
  Edge edge;
  double gain;
};

std::optional<Flip> best_flip(const SphericalTriangulation& t, const Smoothness& smoothness) {
  std::optional<Flip> best;
  for (const auto& triangle : t.triangles())
    for (std::size_t i = 0; i < 3; ++i) {
      const int a = triangle[i], b = triangle[(i + 1) % 3];
      if (a > b || smoothness.fixed(a, b) || !t.can_flip(a, b)) continue;
      const double gain = smoothness.gain(a, b);
      if (gain <= tolerance::flip_gain) continue;
      const bool tie = best && std::abs(gain - best->gain) <= tolerance::flip_gain;
      const bool better =
          !best || (tie ? std::minmax(a, b) < std::minmax(best->edge.first, best->edge.second) : gain > best->gain);
      if (better) best = Flip{{a, b}, gain};
    }
  return best;
}

// Flips that change nothing but the diagonal of a flat quad, so that the choice does not depend on rounding.
void settle_ties(SphericalTriangulation& t, const Smoothness& smoothness) {
  const auto triangles = t.triangles();
  for (const auto& triangle : triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const int a = triangle[i], b = triangle[(i + 1) % 3];
      if (a > b || !t.has_edge(a, b) || smoothness.fixed(a, b) || !t.can_flip(a, b)) continue;
      const bool tie = std::abs(smoothness.gain(a, b)) <= tolerance::flip_gain;
      if (tie && edge_rank(t.opposite(a, b), t.opposite(b, a)) < edge_rank(a, b)) t.flip(a, b);
    }
}

}  // namespace

void smooth_by_flips(SphericalTriangulation& triangulation, const std::set<Edge>& section_edges,
                     const SectionNormals& normals) {
  const Smoothness smoothness(triangulation, section_edges, normals);
  // Every flip lessens the sum of angles; but that of needles is rounding, so the number of flips is bounded too.
  const std::size_t corners = triangulation.points().size();
  for (std::size_t flips = 0; flips < corners * corners; ++flips) {
    const auto flip = best_flip(triangulation, smoothness);
    if (!flip) break;
    triangulation.flip(flip->edge.first, flip->edge.second);
  }
  settle_ties(triangulation, smoothness);
}

}  // namespace cagewright
