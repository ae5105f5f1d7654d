// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <set>

#include "core/meshing/spherical_triangulation.h"

namespace cagewright {

// The sections of a part, for the normals of the triangles that fill them.
struct SectionNormals {
  std::map<int, int> section_of;  // corner -> section; a negative number of its own where it has none
  std::vector<Vector3> outward;   // of each section, unit
};

// The paper's edge flips (3.3, figure 8): flips an edge where that lessens the sum of the angles between the normals of
// neighbouring triangles, the best flip first, until none does; never one of `section_edges`. A triangle that fills a
// section counts with the section's outward normal. Every flip keeps the triangles in front of the centre.
// At most points^2 flips.
void smooth_by_flips(SphericalTriangulation& triangulation, const std::set<Edge>& section_edges,
                     const SectionNormals& normals);

}  // namespace cagewright
