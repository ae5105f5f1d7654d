// SPDX-License-Identifier: BSD-3-Clause
#include "host/view/window/vertex_marks.h"

#include <vtkCellArray.h>
#include <vtkMatrix4x4.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include "host/view/window/colours.h"
#include "host/view/window/depth_order.h"

namespace cagewright::host {
namespace {

constexpr double kSize = 5;  // pixels

}  // namespace

VertexMarks::VertexMarks(vtkRenderer& renderer) : renderer_(renderer) {
  mapper_->ScalarVisibilityOff();
  actor_->SetMapper(mapper_);
  actor_->PickableOff();
  actor_->GetProperty()->LightingOff();
  actor_->GetProperty()->SetColor(colours::outside[0], colours::outside[1], colours::outside[2]);
  draw_slightly_nearer(*actor_);
  set({});
  set_pixel_ratio(1);
  renderer_.AddActor(actor_);
}

VertexMarks::~VertexMarks() { renderer_.RemoveActor(actor_); }

void VertexMarks::set(const std::vector<Point3>& points) {
  const vtkNew<vtkPoints> rows;
  rows->SetDataTypeToDouble();
  const vtkNew<vtkCellArray> cells;
  for (const Point3& point : points) {
    const vtkIdType row = rows->InsertNextPoint(point.data());
    cells->InsertNextCell(1, &row);
  }
  const vtkNew<vtkPolyData> marks;
  marks->SetPoints(rows);
  marks->SetVerts(cells);
  mapper_->SetInputData(marks);
}

void VertexMarks::set_transform(const Matrix4& to_scene) {
  const vtkNew<vtkMatrix4x4> matrix;
  matrix->DeepCopy(to_scene.data());
  actor_->SetUserMatrix(matrix);
}

void VertexMarks::set_visible(bool visible) { actor_->SetVisibility(visible); }

void VertexMarks::set_pixel_ratio(double ratio) {
  actor_->GetProperty()->SetPointSize(static_cast<float>(kSize * ratio));
}

}  // namespace cagewright::host
