// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_PLUGIN_CLIENT_RECORDS_H
#define CAGEWRIGHT_HOST_PLUGIN_CLIENT_RECORDS_H

#include <array>
#include <cstdint>
#include <vector>

#include "host/file/triangle_mesh.h"

namespace cagewright::host {

// cgw_parts with lists: the model cut along the slides.
struct CutModel {
  TriangleMesh mesh;
  std::vector<int> triangle_part;              // of each triangle
  std::vector<bool> is_enclosed;               // of each part: CGW_PART_ENCLOSED
  std::vector<std::array<double, 3>> centers;  // of each part: its projection centre; NaN where it has none
};

// cgw_iteration with lists: one step of the refinement. Points are packed rows of 3.
struct IterationRecord {
  double max_signed_distance = 0;
  std::vector<double> before, after, damping, plane_normals;        // by cage vertex
  std::vector<double> normals, anchors, weights, signed_distances;  // by cage triangle
  std::vector<std::int64_t> outermost;                              // by cage triangle: row of CutModel::mesh, or -1
};

}  // namespace cagewright::host

#endif
