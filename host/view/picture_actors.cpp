// SPDX-License-Identifier: BSD-3-Clause
#include "host/view/picture_actors.h"

#include <vtkExtractEdges.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataNormals.h>
#include <vtkProperty.h>
#include <vtkTrivialProducer.h>
#include <vtkTubeFilter.h>

#include <cstddef>

namespace cagewright::host {
namespace {

constexpr int kEllipseSegments = 96;
constexpr double kCreaseAngle = 50;  // degrees; sharper edges are shaded as edges

constexpr Point kModelGrey{0.74, 0.74, 0.76};
constexpr Point kCageBlue{0.05, 0.10, 0.55};
constexpr Point kCageFaceBlue{0.35, 0.50, 0.95};
constexpr Point kSlideRed{0.90, 0.05, 0.05};
constexpr Point kFailedOrange{1.00, 0.55, 0.00};
constexpr Point kSectionGreen{0.00, 0.62, 0.15};

// Radii of the tubes, in pixels.
constexpr double kCageRadius = 0.9;
constexpr double kSlideRadius = 1.5;
constexpr double kSectionRadius = 1.7;

std::vector<Point> ellipse(const SlideMark& slide) {
  return ellipse_points(slide.center, slide.u, slide.v, kEllipseSegments);
}

std::vector<Point> rectangle(const std::array<double, 12>& corners) {
  std::vector<Point> points(4);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    points[i / 3][i % 3] = corners[i];
  }
  return points;
}

vtkSmartPointer<vtkActor> actor_of(vtkAlgorithm& source, const Point& color) {
  const vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source.GetOutputPort());
  mapper->ScalarVisibilityOff();
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(color[0], color[1], color[2]);
  return actor;
}

// Lines become tubes of flat colour: OpenGL's own wide lines are not drawn everywhere, and shading would mix colours
// that carry meaning.
vtkSmartPointer<vtkActor> tubes(vtkAlgorithm& lines, double radius, const Point& color) {
  const vtkNew<vtkTubeFilter> tube;
  tube->SetInputConnection(lines.GetOutputPort());
  tube->SetRadius(radius);
  tube->SetNumberOfSides(8);
  tube->CappingOn();
  auto actor = actor_of(*tube, color);
  actor->GetProperty()->LightingOff();
  return actor;
}

vtkSmartPointer<vtkActor> loop_actor(const std::vector<std::vector<Point>>& loops, double radius, const Point& color) {
  const vtkNew<vtkTrivialProducer> lines;
  lines->SetOutput(line_polydata(loops, true));
  return tubes(*lines, radius, color);
}

vtkSmartPointer<vtkActor> model_actor(const PictureInput& input) {
  const vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(triangle_polydata(input.model_points, input.model_triangles));
  normals->SetFeatureAngle(kCreaseAngle);
  normals->ConsistencyOff();
  auto actor = actor_of(*normals, kModelGrey);
  actor->GetProperty()->SetOpacity(0.55);
  actor->GetProperty()->SetAmbient(0.15);
  actor->GetProperty()->SetDiffuse(0.85);
  return actor;
}

void add_cage(const PictureInput& input, double pixel, std::vector<vtkSmartPointer<vtkActor>>& actors) {
  const auto mesh = triangle_polydata(input.cage_points, input.cage_triangles);
  const vtkNew<vtkExtractEdges> edges;
  edges->SetInputData(mesh);
  actors.push_back(tubes(*edges, kCageRadius * pixel, kCageBlue));

  const vtkNew<vtkPolyDataNormals> faces;
  faces->SetInputData(mesh);
  faces->ComputePointNormalsOff();
  faces->ComputeCellNormalsOn();
  faces->SplittingOff();
  faces->ConsistencyOff();
  actors.push_back(actor_of(*faces, kCageFaceBlue));
  actors.back()->GetProperty()->SetOpacity(0.08);
}

}  // namespace

std::vector<Point> outline_points(const PictureInput& input) {
  std::vector<Point> points;
  for (const auto rows : {input.model_points, input.cage_points}) {
    for (std::size_t i = 0; i < rows.size(); i += 3) {
      points.push_back({rows[i], rows[i + 1], rows[i + 2]});
    }
  }
  for (const SlideMark& slide : input.slides) {
    const auto loop = ellipse(slide);
    points.insert(points.end(), loop.begin(), loop.end());
  }
  for (const auto& section : input.sections) {
    const auto loop = rectangle(section);
    points.insert(points.end(), loop.begin(), loop.end());
  }
  return points;
}

std::vector<vtkSmartPointer<vtkActor>> make_actors(const PictureInput& input, double pixel) {
  std::vector<vtkSmartPointer<vtkActor>> actors;
  if (!input.model_triangles.empty()) {
    actors.push_back(model_actor(input));
  }
  if (!input.cage_triangles.empty()) {
    add_cage(input, pixel, actors);
  }
  std::vector<std::vector<Point>> good;
  std::vector<std::vector<Point>> failed;
  for (const SlideMark& slide : input.slides) {
    (slide.failed ? failed : good).push_back(ellipse(slide));
  }
  std::vector<std::vector<Point>> sections;
  for (const auto& section : input.sections) {
    sections.push_back(rectangle(section));
  }
  if (!sections.empty()) {
    actors.push_back(loop_actor(sections, kSectionRadius * pixel, kSectionGreen));
  }
  if (!good.empty()) {
    actors.push_back(loop_actor(good, kSlideRadius * pixel, kSlideRed));
  }
  if (!failed.empty()) {
    actors.push_back(loop_actor(failed, kSlideRadius * pixel, kFailedOrange));
  }
  return actors;
}

}  // namespace cagewright::host
