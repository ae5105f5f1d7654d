// SPDX-License-Identifier: BSD-3-Clause
#include "host/view/window/surface_actor.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkIdTypeArray.h>
#include <vtkMatrix4x4.h>
#include <vtkPointData.h>
#include <vtkPolyDataNormals.h>
#include <vtkProperty.h>
#include <vtkUnsignedCharArray.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "host/view/polydata.h"
#include "host/view/window/colours.h"
#include "host/view/window/drawing_order.h"

namespace cagewright::host {
namespace {

constexpr double kCreaseAngle = 50;                   // degrees; sharper edges are shaded as edges
constexpr double kAmbient = 0.2, kWireAmbient = 0.6;  // wires behind the model face away, and are to be seen
constexpr char kVertexOfMesh[] = "vertex of the mesh";

vtkSmartPointer<vtkPolyData> polydata_of(const DrawingOrder& order) {
  const auto polydata = triangle_polydata(order.mesh.points, order.mesh.triangles);
  const vtkNew<vtkIdTypeArray> vertices;
  vertices->SetName(kVertexOfMesh);
  vertices->SetNumberOfValues(polydata->GetNumberOfPoints());
  std::copy(order.vertices.begin(), order.vertices.end(), vertices->GetPointer(0));
  polydata->GetPointData()->AddArray(vertices);
  return polydata;
}

vtkSmartPointer<vtkPolyData> with_normals(vtkPolyData& mesh) {
  const vtkNew<vtkPolyDataNormals> normals;  // creases double vertices, with their data
  normals->SetInputData(&mesh);
  normals->SetFeatureAngle(kCreaseAngle);
  normals->ConsistencyOff();
  normals->Update();
  return normals->GetOutput();
}

vtkSmartPointer<vtkPolyData> edges_of(vtkPolyData& surface) {
  std::vector<std::uint32_t> corners;
  corners.reserve(3 * static_cast<std::size_t>(surface.GetNumberOfPolys()));
  vtkIdType count = 0;
  const vtkIdType* row = nullptr;
  for (vtkIdType i = 0; i < surface.GetNumberOfPolys(); ++i) {
    surface.GetPolys()->GetCellAtId(i, count, row);
    corners.insert(corners.end(), row, row + count);
  }
  const vtkNew<vtkCellArray> cells;
  for (const auto& [a, b] : unique_edges(corners)) {
    const std::array<vtkIdType, 2> ends{a, b};
    cells->InsertNextCell(2, ends.data());
  }
  auto edges = vtkSmartPointer<vtkPolyData>::New();
  edges->SetPoints(surface.GetPoints());
  edges->GetPointData()->ShallowCopy(surface.GetPointData());
  edges->SetLines(cells);
  return edges;
}

// Whether every directed edge occurs as often as its reverse, and the triangles face away from what they enclose. The
// edges are compared by sums of hashes: one pass, no sorting.
bool is_closed_outward(const TriangleMesh& mesh) {
  const auto hash = [](std::uint64_t from, std::uint64_t to) {
    std::uint64_t mixed = (from << 32 | to) + 0x9E3779B97F4A7C15;  // splitmix64
    mixed = (mixed ^ mixed >> 30) * 0xBF58476D1CE4E5B9;
    mixed = (mixed ^ mixed >> 27) * 0x94D049BB133111EB;
    return mixed ^ mixed >> 31;
  };
  std::uint64_t balance = 0;
  double volume = 0;
  const auto corner = [&](std::size_t i) { return Eigen::Vector3d(&mesh.points[3 * std::size_t{mesh.triangles[i]}]); };
  const Eigen::Vector3d origin = mesh.triangles.empty() ? Eigen::Vector3d::Zero() : corner(0);
  for (std::size_t i = 0; i < mesh.triangles.size(); i += 3) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t from = mesh.triangles[i + k], to = mesh.triangles[i + (k + 1) % 3];
      balance += hash(from, to) - hash(to, from);
    }
    volume += (corner(i) - origin).dot((corner(i + 1) - origin).cross(corner(i + 2) - origin));
  }
  return balance == 0 && volume > 0;
}

void set_colour_of(vtkUnsignedCharArray& bytes, vtkIdType row, const Point3& colour) {
  for (std::size_t k = 0; k < 3; ++k) {
    bytes.SetValue(3 * row + static_cast<vtkIdType>(k), static_cast<unsigned char>(std::lround(255 * colour[k])));
  }
}

vtkSmartPointer<vtkUnsignedCharArray> colour_rows(vtkIdType count) {
  auto bytes = vtkSmartPointer<vtkUnsignedCharArray>::New();
  bytes->SetName("colours");
  bytes->SetNumberOfComponents(3);
  bytes->SetNumberOfTuples(count);
  return bytes;
}

}  // namespace

SurfaceActor::SurfaceActor(const TriangleMesh& mesh) {
  const DrawingOrder order = drawing_order(mesh);
  drawn_ = polydata_of(order);
  triangles_ = order.triangles;
  vtkProperty* property = actor_->GetProperty();
  if (mesh.triangle_count() <= kMostSmoothTriangles) {
    drawn_ = with_normals(*drawn_);
    property->SetInterpolationToGouraud();
  } else {
    property->SetInterpolationToFlat();
  }
  mapper_->ScalarVisibilityOff();
  actor_->SetMapper(mapper_);
  actor_->PickableOff();
  set_colour(colours::model);
  set_wireframe(false);
  // What is never seen need not be drawn: a third of the time.
  property->SetBackfaceCulling(is_closed_outward(mesh));
}

void SurfaceActor::set_transform(const Matrix4& to_scene) {
  const vtkNew<vtkMatrix4x4> matrix;
  matrix->DeepCopy(to_scene.data());
  actor_->SetUserMatrix(matrix);
  // VTK lights what turns clockwise on the screen from behind: mirrored, all does.
  const bool is_mirrored = matrix->Determinant() < 0;
  if (is_mirrored != is_reversed_) {
    vtkCellArray* triangles = drawn_->GetPolys();
    for (vtkIdType i = 0; i < triangles->GetNumberOfCells(); ++i) triangles->ReverseCellAtId(i);
    triangles->Modified();
    drawn_->Modified();
    is_reversed_ = is_mirrored;
  }
}

void SurfaceActor::set_colour(const Point3& colour) {
  actor_->GetProperty()->SetColor(colour[0], colour[1], colour[2]);
}

void SurfaceActor::set_wireframe(bool wireframe) {
  vtkProperty* property = actor_->GetProperty();
  const double ambient = wireframe ? kWireAmbient : kAmbient;
  property->SetAmbient(ambient);
  property->SetDiffuse(1 - ambient);
  // VTK draws an edge once for each of its triangles; edges of our own have no triangle to take a colour from.
  const bool has_own_edges = wireframe && !has_triangle_colours_;
  wireframe && !has_own_edges ? property->SetRepresentationToWireframe() : property->SetRepresentationToSurface();
  if (has_own_edges && wires_ == nullptr) wires_ = edges_of(*drawn_);
  vtkPolyData* input = has_own_edges ? wires_ : drawn_;
  if (mapper_->GetInput() != input) mapper_->SetInputData(input);  // also the same would be uploaded again
}

void SurfaceActor::set_triangle_colours(const std::vector<Point3>& colours) {
  const auto bytes = colour_rows(drawn_->GetNumberOfCells());
  for (vtkIdType i = 0; i < drawn_->GetNumberOfCells(); ++i) {
    set_colour_of(*bytes, i, colours[triangles_[static_cast<std::size_t>(i)]]);
  }
  drawn_->GetCellData()->SetScalars(bytes);
  has_triangle_colours_ = true;
  mapper_->SetScalarModeToUseCellData();
}

void SurfaceActor::set_vertex_colours(const std::vector<Point3>& colours) {
  const auto bytes = colour_rows(drawn_->GetNumberOfPoints());
  auto* vertices = vtkIdTypeArray::SafeDownCast(drawn_->GetPointData()->GetArray(kVertexOfMesh));
  for (vtkIdType i = 0; i < drawn_->GetNumberOfPoints(); ++i) {
    set_colour_of(*bytes, i, colours[static_cast<std::size_t>(vertices->GetValue(i))]);
  }
  drawn_->GetPointData()->SetScalars(bytes);
  if (wires_ != nullptr) wires_->GetPointData()->SetScalars(bytes);
  mapper_->SetScalarModeToUsePointData();
}

void SurfaceActor::show_own_colours(bool shown) { mapper_->SetScalarVisibility(shown); }

}  // namespace cagewright::host
