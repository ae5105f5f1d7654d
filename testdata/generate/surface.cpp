// SPDX-License-Identifier: BSD-3-Clause
#include "testdata/generate/surface.h"

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkFloatArray.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataConnectivityFilter.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace cagewright::testdata {
namespace {

constexpr int kBlock = 8;  // grid points along a block that is filled at once where the surface is far
constexpr int kRelaxations = 12;
constexpr double kOnSurface = 1e-9;

using Index3 = Eigen::Vector3i;

// Fills one block of grid points. Where the value in the middle says that the surface is clear of the block, by a
// factor that covers the field's error as a distance, one value does for all.
void fill_block(const Field& field, vtkImageData& grid, const Index3& first, const Index3& end) {
  const Eigen::Vector3d origin(grid.GetOrigin());
  const double cell = grid.GetSpacing()[0];
  const Eigen::Vector3d middle = origin + cell * 0.5 * (first + end - Index3::Ones()).cast<double>();
  const double middle_value = field.value(middle);
  const bool far = std::abs(middle_value) > 3 * cell * (end - first).cast<double>().norm() / 2;
  for (int k = first[2]; k < end[2]; ++k) {
    for (int j = first[1]; j < end[1]; ++j) {
      auto* row = static_cast<float*>(grid.GetScalarPointer(first[0], j, k));
      for (int i = first[0]; i < end[0]; ++i) {
        const double value = far ? middle_value : field.value(origin + cell * Index3(i, j, k).cast<double>());
        // A zero at a grid point would pull all its crossings together, into triangles without area.
        *row++ = static_cast<float>(std::abs(value) < 1e-4 * cell ? 1e-4 * cell : value);
      }
    }
  }
}

vtkSmartPointer<vtkImageData> sample(const Field& field, int resolution) {
  const Eigen::AlignedBox3d box = field.bounds();
  const double cell = box.sizes().maxCoeff() / resolution;
  const Index3 points = (box.sizes() / cell).array().ceil().cast<int>() + 2;
  auto grid = vtkSmartPointer<vtkImageData>::New();
  grid->SetDimensions(points.data());
  grid->SetOrigin(box.min().data());
  grid->SetSpacing(cell, cell, cell);
  grid->AllocateScalars(VTK_FLOAT, 1);
  for (int k = 0; k < points[2]; k += kBlock)
    for (int j = 0; j < points[1]; j += kBlock)
      for (int i = 0; i < points[0]; i += kBlock) {
        const Index3 first(i, j, k);
        fill_block(field, *grid, first, (first.array() + kBlock).min(points.array()).matrix());
      }
  return grid;
}

vtkSmartPointer<vtkPolyData> contour(vtkImageData& grid) {
  vtkNew<vtkFlyingEdges3D> edges;
  edges->SetInputData(&grid);
  edges->SetValue(0, 0.0);
  edges->ComputeNormalsOff();
  edges->ComputeGradientsOff();
  edges->ComputeScalarsOff();
  vtkNew<vtkPolyDataConnectivityFilter> largest;
  largest->SetInputConnection(edges->GetOutputPort());
  largest->SetExtractionModeToLargestRegion();
  largest->Update();
  return largest->GetOutput();
}

// Copies the triangles and those vertices that they use.
TriangleMesh copy_mesh(vtkPolyData& surface) {
  TriangleMesh mesh;
  std::vector<std::int64_t> row(static_cast<std::size_t>(surface.GetNumberOfPoints()), -1);
  auto cells = vtk::TakeSmartPointer(surface.GetPolys()->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell()) {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    cells->GetCurrentCell(count, ids);
    auto& triangle = mesh.triangles.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      std::int64_t& index = row[static_cast<std::size_t>(ids[k])];
      if (index < 0) {
        index = static_cast<std::int64_t>(mesh.vertices.size());
        mesh.vertices.emplace_back(surface.GetPoint(ids[k]));
      }
      triangle[k] = static_cast<std::uint32_t>(index);
    }
  }
  return mesh;
}

void turn_outward(TriangleMesh& mesh, const Field& field) {
  double agreement = 0;
  for (const auto& [ia, ib, ic] : mesh.triangles) {
    const Eigen::Vector3d &a = mesh.vertices[ia], &b = mesh.vertices[ib], &c = mesh.vertices[ic];
    agreement += (b - a).cross(c - a).dot(field.gradient((a + b + c) / 3));
  }
  if (agreement < 0)
    for (auto& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
}

Eigen::Vector3d project(const Field& field, Eigen::Vector3d p) {
  for (int step = 0; step < 8; ++step) {
    const double value = field.value(p);
    if (std::abs(value) < kOnSurface) break;
    const Eigen::Vector3d slope = field.gradient(p);
    p -= value * slope / slope.squaredNorm();
  }
  return p;
}

// Slides vertices along the surface towards the mean of their neighbours: contouring leaves slivers.
void even_out(TriangleMesh& mesh, const Field& field) {
  const std::size_t count = mesh.vertices.size();
  for (Eigen::Vector3d& v : mesh.vertices) v = project(field, v);
  for (int round = 0; round < kRelaxations; ++round) {
    std::vector<Eigen::Vector3d> sum(count, Eigen::Vector3d::Zero());
    std::vector<double> weight(count, 0);
    for (const auto& triangle : mesh.triangles) {
      for (std::size_t k = 0; k < 3; ++k) {
        sum[triangle[k]] += mesh.vertices[triangle[(k + 1) % 3]] + mesh.vertices[triangle[(k + 2) % 3]];
        weight[triangle[k]] += 2;
      }
    }
    for (std::size_t v = 0; v < count; ++v) {
      const Eigen::Vector3d normal = field.gradient(mesh.vertices[v]).normalized();
      Eigen::Vector3d step = sum[v] / weight[v] - mesh.vertices[v];
      step -= normal * normal.dot(step);
      mesh.vertices[v] = project(field, mesh.vertices[v] + 0.5 * step);
    }
  }
}

}  // namespace

TriangleMesh mesh_surface(const Field& field, int resolution) {
  if (resolution < 8) throw std::invalid_argument("the resolution must be at least 8");
  const vtkSmartPointer<vtkImageData> grid = sample(field, resolution);
  const vtkSmartPointer<vtkPolyData> surface = contour(*grid);
  TriangleMesh mesh = copy_mesh(*surface);
  turn_outward(mesh, field);
  even_out(mesh, field);
  return mesh;
}

}  // namespace cagewright::testdata
