// SPDX-License-Identifier: BSD-3-Clause
#include "host/view/window/cage_actors.h"

#include <vtkMatrix4x4.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <cstddef>
#include <utility>
#include <vector>

#include "host/view/window/colours.h"

namespace cagewright::host {
namespace {

constexpr double kFaceOpacity = 0.13, kStaleFaceOpacity = 0.06;
constexpr LineStyle kEdges{colours::cage_edge, 1.5, 1, 0.35};
constexpr LineStyle kStaleEdges{colours::stale_edge, 1.2, 0.7, 0.2};
constexpr LineStyle kSections{colours::section, 2.2, 1, 0.35};
constexpr LineStyle kStaleSections{colours::stale_section, 2, 0.7, 0.2};

std::vector<std::vector<Point>> edges_of(const TriangleMesh& mesh) {
  const auto point = [&](std::uint32_t vertex) {
    return Point{mesh.points[3 * vertex], mesh.points[3 * vertex + 1], mesh.points[3 * vertex + 2]};
  };
  std::vector<std::vector<Point>> runs;
  for (const auto& [a, b] : unique_edges(mesh.triangles)) runs.push_back({point(a), point(b)});
  return runs;
}

}  // namespace

CageActors::CageActors(vtkRenderer& renderer)
    : renderer_(renderer), edges_(renderer, kEdges), sections_(renderer, kSections) {
  mapper_->ScalarVisibilityOff();
  faces_->SetMapper(mapper_);
  faces_->PickableOff();
  vtkProperty* property = faces_->GetProperty();
  // All faces of one colour: then the order in which they are blended does not show.
  property->LightingOff();
  property->SetColor(colours::cage_face[0], colours::cage_face[1], colours::cage_face[2]);
  renderer_.AddActor(faces_);
  apply();
}

CageActors::~CageActors() { renderer_.RemoveActor(faces_); }

void CageActors::set(const ShownCage* cage) {
  const TriangleMesh mesh = cage == nullptr ? TriangleMesh{} : cage->mesh;
  std::vector<std::vector<Point>> sections;
  if (cage != nullptr) {
    for (const auto& corners : cage->sections) sections.emplace_back(corners.begin(), corners.end());
  }
  sections_.set(std::move(sections), true);
  is_stale_ = cage != nullptr && cage->is_stale;
  if (mesh.points != shown_.points || mesh.triangles != shown_.triangles) {
    shown_ = mesh;
    mapper_->SetInputData(triangle_polydata(shown_.points, shown_.triangles));
    edges_.set(edges_of(shown_), false);
  }
  apply();
}

void CageActors::set_transform(const Matrix4& to_scene) {
  const vtkNew<vtkMatrix4x4> matrix;
  matrix->DeepCopy(to_scene.data());
  faces_->SetUserMatrix(matrix);
  edges_.set_transform(to_scene);
  sections_.set_transform(to_scene);
}

void CageActors::set_options(const ViewOptions& options) {
  options_ = options;
  apply();
}

void CageActors::set_pixel_ratio(double ratio) {
  edges_.set_pixel_ratio(ratio);
  sections_.set_pixel_ratio(ratio);
}

void CageActors::apply() {
  faces_->SetVisibility(options_.cage && options_.cage_faces && !shown_.triangles.empty());
  faces_->GetProperty()->SetOpacity(is_stale_ ? kStaleFaceOpacity : kFaceOpacity);
  edges_.set_visible(options_.cage);
  edges_.set_style(is_stale_ ? kStaleEdges : kEdges);
  sections_.set_visible(options_.sections);
  sections_.set_style(is_stale_ ? kStaleSections : kSections);
}

}  // namespace cagewright::host
