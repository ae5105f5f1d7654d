// SPDX-License-Identifier: BSD-3-Clause
#include "host/view/window/place_mark.h"

#include <vtkCellArray.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProperty2D.h>
#include <vtkRenderer.h>

#include <cmath>
#include <initializer_list>
#include <numbers>

#include "host/view/window/colours.h"
#include "host/view/window/projection.h"

namespace cagewright::host {
namespace {

// Pixels.
constexpr double kRadius = 14;
constexpr double kTick = 8;  // of the cross, inwards and outwards from the ring: what is at the place stays seen
constexpr double kWidth = 2, kRim = 2;
constexpr int kSegments = 48;

vtkNew<vtkPolyData> shape(double ratio) {
  const vtkNew<vtkPoints> points;
  const vtkNew<vtkCellArray> lines;
  const auto add = [&](double angle, double radius) {
    return points->InsertNextPoint(ratio * radius * std::cos(angle), ratio * radius * std::sin(angle), 0);
  };
  lines->InsertNextCell(kSegments + 1);
  for (int k = 0; k <= kSegments; ++k) lines->InsertCellPoint(add(2 * std::numbers::pi * k / kSegments, kRadius));
  for (int k = 0; k < 4; ++k) {
    const double angle = std::numbers::pi / 2 * k;
    lines->InsertNextCell({add(angle, kRadius - kTick), add(angle, kRadius + kTick)});
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetLines(lines);
  return data;
}

}  // namespace

PlaceMark::PlaceMark(vtkRenderer& renderer) : renderer_(renderer) {
  const Point3 rim{0.05, 0.05, 0.06};
  for (const bool is_mark : {false, true}) {
    Outline& outline = outlines_[is_mark];
    const Point3& colour = is_mark ? colours::failed_slide : rim;
    outline.actor->SetMapper(outline.mapper);
    outline.actor->GetProperty()->SetColor(colour[0], colour[1], colour[2]);
    outline.actor->SetLayerNumber(is_mark ? 1 : 0);
    outline.actor->PickableOff();
    outline.actor->VisibilityOff();
    renderer_.AddActor2D(outline.actor);
  }
}

PlaceMark::~PlaceMark() {
  for (const Outline& outline : outlines_) renderer_.RemoveActor2D(outline.actor);
}

void PlaceMark::set(const std::optional<Point3>& place) { place_ = place; }

void PlaceMark::follow(const Eigen::Matrix4d& to_scene) {
  const Projection projection(renderer_);
  Projection::Seen seen;
  if (place_) seen = projection.see(transformed(to_scene, to_vector(*place_)));
  for (const Outline& outline : outlines_) outline.actor->SetVisibility(seen.is_visible);
  if (!seen.is_visible) return;
  const double ratio = pixel_ratio(renderer_);
  for (std::size_t k = 0; k < outlines_.size(); ++k) {
    const Outline& outline = outlines_[k];
    if (ratio != ratio_) {
      outline.mapper->SetInputData(shape(ratio));
      outline.actor->GetProperty()->SetLineWidth(static_cast<float>(ratio * (kWidth + (k == 0 ? 2 * kRim : 0))));
    }
    outline.actor->SetPosition(seen.x, seen.y);
  }
  ratio_ = ratio;
}

}  // namespace cagewright::host
