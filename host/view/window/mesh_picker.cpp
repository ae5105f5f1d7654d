// SPDX-License-Identifier: BSD-3-Clause
#include "host/view/window/mesh_picker.h"

#include <vtkGenericCell.h>
#include <vtkStaticCellLocator.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "host/view/polydata.h"

namespace cagewright::host {

using Eigen::Vector3d;

struct MeshPicker::State {
  std::shared_ptr<const TriangleMesh> mesh;
  vtkSmartPointer<vtkStaticCellLocator> locator;  // null until it is needed
  vtkNew<vtkGenericCell> cell;
  double bounds[6] = {};

  Vector3d corner(vtkIdType triangle, std::size_t which) const {
    const std::size_t row = mesh->triangles[3 * static_cast<std::size_t>(triangle) + which];
    return Vector3d(&mesh->points[3 * row]);
  }
  void build() {
    const auto polydata = triangle_polydata(mesh->points, mesh->triangles);
    polydata->BuildCells();
    polydata->GetBounds(bounds);
    locator = vtkSmartPointer<vtkStaticCellLocator>::New();
    locator->SetDataSet(polydata);
    locator->BuildLocator();
  }
};

MeshPicker::MeshPicker(std::shared_ptr<const TriangleMesh> mesh) : state_(std::make_unique<State>()) {
  state_->mesh = std::move(mesh);
}
MeshPicker::~MeshPicker() = default;
MeshPicker::MeshPicker(MeshPicker&&) noexcept = default;
MeshPicker& MeshPicker::operator=(MeshPicker&&) noexcept = default;

std::optional<MeshHit> MeshPicker::first_hit(const Vector3d& origin, const Vector3d& direction) const {
  if (state_->mesh->triangles.empty()) return std::nullopt;
  if (state_->locator == nullptr) state_->build();
  // The line from before the box to behind it: the locator takes segments.
  const Vector3d low(state_->bounds[0], state_->bounds[2], state_->bounds[4]);
  const Vector3d high(state_->bounds[1], state_->bounds[3], state_->bounds[5]);
  const double radius = 0.51 * (high - low).norm();
  const double middle = ((low + high) / 2 - origin).dot(direction);
  const double begin = std::max(0.0, middle - radius), end = middle + radius;
  if (!(end > begin)) return std::nullopt;
  const Vector3d from = origin + begin * direction, to = origin + end * direction;
  double along = 0, point[3], inside[3];
  int part = 0;
  vtkIdType triangle = -1;
  // No tolerance: with one the locator takes triangles that the line passes by, and nearer ones at that.
  if (state_->locator->IntersectWithLine(from.data(), to.data(), 0, along, point, inside, part, triangle,
                                         state_->cell) == 0) {
    return std::nullopt;
  }
  const Vector3d a = state_->corner(triangle, 0), b = state_->corner(triangle, 1), c = state_->corner(triangle, 2);
  const Vector3d hit(point);
  return MeshHit{hit, (b - a).cross(c - a).stableNormalized(), (hit - origin).dot(direction)};
}

}  // namespace cagewright::host
