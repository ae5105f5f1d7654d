// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "core/slide/slide.h"

namespace cagewright {

// The rectangular cross section in a slide's plane (paper 3.2): corners are center +- p +- q.
struct SectionFrame {
  Vector3 center;
  Vector3 normal;                    // the slide's, along p x q
  Vector3 p, q;                      // half edges, orthogonal, model units; the rectangle circumscribes the ellipse
  Vector2 x;                         // along pow4 of p in the slide's coordinates (u, v)
  Vector2 linear = Vector2::Zero();  // the minimiser of (1) as a quadratic form: x, or where x started

  // Counter-clockwise round the normal: +p+q, -p+q, -p-q, +p-q.
  std::array<Vector3, 4> corners() const;
};

// Slides that bound the same part, each pair once, first < second.
using NeighbourPairs = std::vector<std::pair<int, int>>;

// Of (1) as a quadratic form in x, or over the angles of the sections.
enum class OrientMinimum { linear, angles };

// Minimises equation (1): smoothness (2) between neighbours with weights (4), alignment (5) with strength `lambda`.
// One sparse linear solve of size 2 |slides|, as in the paper. Its x_k are shorter than 1 where terms disagree, and
// taken to length 1 they are no minimum any more; with OrientMinimum::angles Newton steps over the angles go on to the
// next one, which never raises (1). Then the fourth root nearest to u. Between almost perpendicular slides the first
// case of (2) is taken both ways, since it is not symmetric. Slides that nothing orients (a circle without alignment)
// keep u. Thread-safe. O(|slides| + |neighbours|) memory, and time for the planar graphs that parts make.
std::vector<SectionFrame> orient(const std::vector<Ellipse>& slides, const NeighbourPairs& neighbours, double lambda,
                                 OrientMinimum minimum = OrientMinimum::linear);

// Equation (1) at given directions: angle_k is that of p_k in the coordinates (u_k, v_k), radians. For validation.
double orientation_energy(const std::vector<Ellipse>& slides, const NeighbourPairs& neighbours, double lambda,
                          const std::vector<double>& angles);

}  // namespace cagewright
