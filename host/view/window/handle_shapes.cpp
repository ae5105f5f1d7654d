// SPDX-License-Identifier: BSD-3-Clause
#include "host/view/window/handle_shapes.h"

#include <vtkAppendPolyData.h>
#include <vtkConeSource.h>
#include <vtkCubeSource.h>
#include <vtkNew.h>
#include <vtkSphereSource.h>
#include <vtkTubeFilter.h>

#include <cmath>
#include <cstddef>
#include <numbers>

#include "host/view/polydata.h"
#include "host/view/window/projection.h"

namespace cagewright::host {
namespace {

using Eigen::Vector3d;

constexpr Point3 kColours[] = {{0.95, 0.25, 0.22}, {0.35, 0.85, 0.25}, {0.28, 0.50, 1.00}};
constexpr Point3 kPlaneColour{0.95, 0.85, 0.30}, kViewColour{0.40, 0.85, 0.95};

constexpr double kBegin = 0.16, kShaft = 0.015, kRing = 0.013;
constexpr double kConeLength = 0.24, kConeRadius = 0.075, kBox = 0.13, kBall = 0.075;
constexpr double kSquareBegin = 0.26, kSquareEnd = 0.44;
constexpr int kRingSegments = 96;

Vector3d unit(std::size_t axis) { return Vector3d::Unit(static_cast<Eigen::Index>(axis)); }

vtkSmartPointer<vtkPolyData> tube(const std::vector<Vector3d>& run, double radius, bool closed) {
  std::vector<Point> points;
  for (const Vector3d& point : run) points.push_back(to_point(point));
  const vtkNew<vtkTubeFilter> filter;
  filter->SetInputData(line_polydata({points}, closed));
  filter->SetRadius(radius);
  filter->SetNumberOfSides(8);
  filter->CappingOn();
  filter->Update();
  return filter->GetOutput();
}

vtkSmartPointer<vtkPolyData> joined(vtkPolyData* a, vtkPolyData* b) {
  const vtkNew<vtkAppendPolyData> both;
  both->AddInputData(a);
  both->AddInputData(b);
  both->Update();
  return both->GetOutput();
}

vtkSmartPointer<vtkPolyData> box_at(const Vector3d& center, double side) {
  const vtkNew<vtkCubeSource> box;
  box->SetCenter(center.x(), center.y(), center.z());
  box->SetXLength(side);
  box->SetYLength(side);
  box->SetZLength(side);
  box->Update();
  return box->GetOutput();
}

HandleShape arrow(std::size_t axis) {
  const Vector3d along = unit(axis), middle = (1 - kConeLength / 2) * along;
  const vtkNew<vtkConeSource> cone;
  cone->SetDirection(along.x(), along.y(), along.z());
  cone->SetCenter(middle.x(), middle.y(), middle.z());
  cone->SetHeight(kConeLength);
  cone->SetRadius(kConeRadius);
  cone->SetResolution(20);
  cone->Update();
  const auto shaft = tube({kBegin * along, (1 - kConeLength) * along}, kShaft, false);
  return {static_cast<HandleWay>(axis),
          joined(shaft, cone->GetOutput()),
          {kBegin * along, along},
          7,
          {0.85 * along, 0.65 * along, along},
          kColours[axis]};
}

HandleShape scale_arm(std::size_t axis) {
  const Vector3d along = unit(axis);
  const auto shaft = tube({kBegin * along, along}, kShaft, false);
  return {static_cast<HandleWay>(axis), joined(shaft, box_at(along, kBox)),
          {kBegin * along, along},      8,
          {along, 0.65 * along},        kColours[axis]};
}

HandleShape ring(std::size_t axis) {
  const Vector3d a = unit((axis + 1) % 3), b = unit((axis + 2) % 3);
  HandleShape shape;
  shape.way = static_cast<HandleWay>(axis);
  for (int i = 0; i < kRingSegments; ++i) {
    const double t = 2 * std::numbers::pi * i / kRingSegments;
    shape.outline.push_back(std::cos(t) * a + std::sin(t) * b);
  }
  shape.surface = tube(shape.outline, kRing, true);
  // Between the crossings with the other rings first.
  for (std::size_t i = 0; i < kRingSegments; ++i) {
    shape.places.push_back(shape.outline[(kRingSegments / 8 + 29 * i) % kRingSegments]);
  }
  shape.outline.push_back(shape.outline.front());
  shape.colour = kColours[axis];
  return shape;
}

HandleShape plane_square() {
  const double middle = (kSquareBegin + kSquareEnd) / 2, side = kSquareEnd - kSquareBegin;
  const Vector3d a(kSquareBegin, kSquareBegin, 0), b(kSquareEnd, kSquareBegin, 0), c(kSquareEnd, kSquareEnd, 0),
      d(kSquareBegin, kSquareEnd, 0), center(middle, middle, 0);
  const vtkNew<vtkCubeSource> plate;
  plate->SetCenter(middle, middle, 0);
  plate->SetXLength(side);
  plate->SetYLength(side);
  plate->SetZLength(0.02);
  plate->Update();
  return {HandleWay::plane, plate->GetOutput(), {a, b, c, d, a, c}, 3, {center, c, b, d}, kPlaneColour};
}

HandleShape ball() {
  const vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(kBall);
  sphere->SetThetaResolution(20);
  sphere->SetPhiResolution(14);
  sphere->Update();
  return {HandleWay::view, sphere->GetOutput(), {Vector3d::Zero()}, 9, {Vector3d::Zero()}, kViewColour};
}

HandleShape center_box() {
  return {HandleWay::plane, box_at(Vector3d::Zero(), kBox), {Vector3d::Zero()}, 9, {Vector3d::Zero()}, kPlaneColour};
}

}  // namespace

std::vector<HandleShape> handle_shapes(SlideHandles::Mode mode) {
  switch (mode) {
    case SlideHandles::Mode::move:
      return {arrow(0), arrow(1), arrow(2), plane_square(), ball()};
    case SlideHandles::Mode::turn:
      return {ring(0), ring(1), ring(2)};
    case SlideHandles::Mode::scale:
      return {scale_arm(0), scale_arm(1), center_box()};
    case SlideHandles::Mode::none:
      break;
  }
  return {};
}

}  // namespace cagewright::host
