// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "core/orient/orient.h"
#include "core/segment/segment.h"

namespace cagewright {

struct Cage {
  Points points;                     // section corners first: row 4 k + i is corner i of section k; then caps and boxes
  Triangles triangles;               // outward
  std::vector<int> vertex_section;   // of each point: section k, or -1 (a cap's or a box's corner)
  std::vector<int> triangle_part;    // of each triangle
  std::vector<Vector3> part_center;  // of each part: the projection centre that sees all of its sections from inside
};

// Meshes every part between its sections (paper 3.3) and joins them: a leaf gets a rectangular cap, a part without
// section its bounding box (none where the part is enclosed), any other part the triangulation of its section corners
// on a sphere round a centre that sees every section from inside: Delaunay with the section edges as constraints, then
// the paper's flips, never across a section edge. The union is a closed, consistently oriented 2-manifold.
// `names` are the slides', for the sentences.
// Throws Error: sections_overlap (no centre sees them side by side; names slides), parts_share_wall (two parts between
// the same slides). Thread-safe. O(sum over parts of sections^3): parts have few sections.
Cage mesh_cage(const Segmentation& segmentation, const std::vector<SectionFrame>& sections,
               const std::vector<std::string>& names);

}  // namespace cagewright
