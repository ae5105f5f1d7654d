// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
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
  // Where limbs were made one (core/enclose/merge_limbs.h): of each section the rows of its corners, -1 for those that
  // are gone; row 4 k + i then says nothing. Else empty.
  std::vector<std::array<int, 4>> section_vertices;

  std::array<int, 4> corners_of(int section) const {
    if (section_vertices.empty()) return {4 * section, 4 * section + 1, 4 * section + 2, 4 * section + 3};
    return section_vertices[static_cast<std::size_t>(section)];
  }
  bool has_whole(int section) const {
    const std::array<int, 4> rows = corners_of(section);
    return *std::min_element(rows.begin(), rows.end()) >= 0;
  }
};

// Meshes every part between its sections (paper 3.3) and joins them: a leaf gets a rectangular cap, a limb
// that no slide cuts off one, too (limb_caps.h), a part without section its bounding box (none where the part is
// enclosed), any other part the triangulation of its section corners on a sphere round a centre that sees every section
// from inside: Delaunay with the section edges as constraints, then the paper's flips, never across a section edge. The
// union is a closed, consistently oriented 2-manifold. `names` are the slides', for the sentences. Throws Error:
// sections_overlap (no centre sees them side by side; names slides), parts_share_wall (two parts between the same
// slides). Thread-safe. O(sum over parts of sections^3, and of vertices times faces of the
// corners' hull for each limb's cap): parts have few sections.
Cage mesh_cage(const Segmentation& segmentation, const std::vector<SectionFrame>& sections,
               const std::vector<std::string>& names);

}  // namespace cagewright
