// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "core/meshing/meshing.h"

namespace cagewright {

// A cage's cross section as it came out: four corners, counter-clockwise round the slide's normal, and that slide's
// plane. NaN: a corner that is gone (Cage::section_vertices).
struct PlacedSection {
  std::array<Vector3, 4> corners;
  Vector3 center, normal;  // normal: unit
};

// The sections of a cage.
std::vector<PlacedSection> place_sections(const std::vector<SectionFrame>& frames, const Cage& cage);

// What the paper asks of sections in 3.2, as numbers: 0 is perfect for all of them; NaN where a section is not whole.
struct SectionQuality {
  // Of each section: the largest difference of a corner's angle from a right one, radians. The angle is the inner one,
  // seen along the normal: more than pi where a corner turns inward. Two corners in one place: pi / 2.
  std::vector<double> squareness;
  // Of each section: the largest distance of a corner from the slide's plane, over the diagonal.
  std::vector<double> planarity;
  // Of each pair of neighbours: radians, 0 to pi / 4, the angle t for which the term of (2) is w (2 sin 2t)^2. Normals
  // less than 45 degrees apart, either way round: the smaller rotation that takes one normal's line to the other's is
  // applied, and t is the angle between the nearest axes. Else: the larger of the angles, in each of the two planes,
  // between the projection of the other normal and the nearest axis. The axes of a section that is no rectangle: the
  // mean, as 4th powers, of the directions of its first and its second pair of edges.
  std::vector<double> twist;

  double worst_squareness() const;  // of those that are whole; 0 where there is none; the same below
  double worst_planarity() const;
  double worst_twist() const;
};

// `diagonal` > 0: of the model's bounding box, model units. Thread-safe. O(sections + neighbours).
SectionQuality measure_sections(const std::vector<PlacedSection>& sections, const NeighbourPairs& neighbours,
                                double diagonal);

}  // namespace cagewright
