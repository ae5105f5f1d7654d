// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "testdata/generate/triangle_mesh.h"

namespace cagewright::testdata {

// A closed polygon in which a plane meets a surface.
struct PlaneLoop {
  std::vector<Eigen::Vector3d> points;
  std::vector<std::size_t> triangles;               // those crossed, sorted
  std::vector<std::array<std::uint32_t, 2>> edges;  // those crossed, the lower vertex first, sorted
};

// All loops of a closed, consistently oriented mesh in the plane through `point`. O(n log n).
std::vector<PlaneLoop> cut_by_plane(const TriangleMesh& mesh, const Eigen::Vector3d& point,
                                    const Eigen::Vector3d& normal);

// Whether the loop runs round the point, which lies in the loop's plane.
bool encloses(const PlaneLoop& loop, const Eigen::Vector3d& point, const Eigen::Vector3d& normal);

}  // namespace cagewright::testdata
