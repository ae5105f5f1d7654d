// SPDX-License-Identifier: BSD-3-Clause
#include "host/view/polydata.h"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkTypeInt32Array.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace cagewright::host {

vtkSmartPointer<vtkPolyData> triangle_polydata(std::span<const double> points,
                                               std::span<const std::uint32_t> triangles) {
  const vtkNew<vtkDoubleArray> rows;
  rows->SetNumberOfComponents(3);
  rows->SetNumberOfTuples(static_cast<vtkIdType>(points.size() / 3));
  std::copy(points.begin(), points.end(), rows->GetPointer(0));
  const vtkNew<vtkPoints> positions;
  positions->SetData(rows);

  const vtkNew<vtkTypeInt32Array> offsets, corners;
  offsets->SetNumberOfValues(static_cast<vtkIdType>(triangles.size() / 3 + 1));
  for (vtkIdType i = 0; i < offsets->GetNumberOfValues(); ++i) {
    offsets->SetValue(i, static_cast<vtkTypeInt32>(3 * i));
  }
  corners->SetNumberOfValues(static_cast<vtkIdType>(triangles.size()));
  std::transform(triangles.begin(), triangles.end(), corners->GetPointer(0),
                 [](std::uint32_t corner) { return static_cast<vtkTypeInt32>(corner); });
  const vtkNew<vtkCellArray> cells;
  cells->SetData(offsets, corners);

  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(positions);
  mesh->SetPolys(cells);
  return mesh;
}

vtkSmartPointer<vtkPolyData> line_polydata(const std::vector<std::vector<Point>>& runs, bool closed) {
  const vtkNew<vtkPoints> rows;
  rows->SetDataTypeToDouble();
  const vtkNew<vtkCellArray> cells;
  for (const auto& run : runs) {
    const vtkIdType first = rows->GetNumberOfPoints();
    cells->InsertNextCell(static_cast<int>(run.size()) + (closed ? 1 : 0));
    for (const Point& point : run) {
      cells->InsertCellPoint(rows->InsertNextPoint(point.data()));
    }
    if (closed) {
      cells->InsertCellPoint(first);
    }
  }
  auto lines = vtkSmartPointer<vtkPolyData>::New();
  lines->SetPoints(rows);
  lines->SetLines(cells);
  return lines;
}

std::vector<std::array<std::uint32_t, 2>> unique_edges(std::span<const std::uint32_t> triangles) {
  std::vector<std::array<std::uint32_t, 2>> edges(triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const auto [low, high] = std::minmax(triangles[i], triangles[i % 3 == 2 ? i - 2 : i + 1]);
    edges[i] = {low, high};
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

std::vector<Point> ellipse_points(const Point& center, const Point& u, const Point& v, int segments) {
  std::vector<Point> points(static_cast<std::size_t>(segments));
  for (int i = 0; i < segments; ++i) {
    const double t = 2 * std::numbers::pi * i / segments;
    for (std::size_t k = 0; k < 3; ++k) {
      points[static_cast<std::size_t>(i)][k] = center[k] + std::cos(t) * u[k] + std::sin(t) * v[k];
    }
  }
  return points;
}

}  // namespace cagewright::host
