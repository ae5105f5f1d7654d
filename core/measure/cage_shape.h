// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "core/mesh/types.h"

namespace cagewright {

// How well shaped a cage's triangles are, by themselves.
struct CageShape {
  // Interior dihedral angles, radians, 0 to 2 pi: pi where the cage is flat, less where it bulges out. Over the edges
  // with two triangles that have an area and run the edge in opposite directions; empty where there is none.
  std::optional<double> least_dihedral, greatest_dihedral;
  // Longest edge over 2 sqrt(3) times the inradius, as L_max (L_0 + L_1 + L_2) / (4 sqrt(3) area): 1 for an equilateral
  // triangle, infinite for one without area (Stimpson et al., The Verdict Geometric Quality Library, SAND2007-1751).
  double least_aspect = 0, greatest_aspect = 0;
};

// Vertices at equal positions count as one. Throws Error: those of weld. Thread-safe. O(n).
CageShape measure_shape(const IndexedMesh& cage);

}  // namespace cagewright
