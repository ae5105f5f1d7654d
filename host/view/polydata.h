// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_VIEW_POLYDATA_H
#define CAGEWRIGHT_HOST_VIEW_POLYDATA_H

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace cagewright::host {

using Point = std::array<double, 3>;

// Triangles as VTK has them: points packed n x 3, triangles m x 3 indices below n. Copies. O(n + m).
vtkSmartPointer<vtkPolyData> triangle_polydata(std::span<const double> points,
                                               std::span<const std::uint32_t> triangles);

// One cell for each run of points; closed: with a segment from the last to the first.
vtkSmartPointer<vtkPolyData> line_polydata(const std::vector<std::vector<Point>>& runs, bool closed);

// Every edge of the triangles once, the lower index first, in ascending order. O(m log m).
std::vector<std::array<std::uint32_t, 2>> unique_edges(std::span<const std::uint32_t> triangles);

// `segments` points of center + cos(t) u + sin(t) v, t from 0 in equal steps.
std::vector<Point> ellipse_points(const Point& center, const Point& u, const Point& v, int segments);

}  // namespace cagewright::host

#endif
