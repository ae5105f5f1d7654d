// SPDX-License-Identifier: BSD-3-Clause
#include "host/view/picture_actors.h"

#include <vtkCellArray.h>
#include <vtkExtractEdges.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataNormals.h>
#include <vtkProperty.h>
#include <vtkTrivialProducer.h>
#include <vtkTubeFilter.h>

#include <cmath>
#include <cstddef>
#include <numbers>

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

vtkSmartPointer<vtkPolyData> surface(std::span<const double> points, std::span<const std::uint32_t> triangles) {
  const vtkNew<vtkPoints> rows;
  rows->SetDataTypeToDouble();
  rows->SetNumberOfPoints(static_cast<vtkIdType>(points.size() / 3));
  for (std::size_t i = 0; i < points.size() / 3; ++i) {
    rows->SetPoint(static_cast<vtkIdType>(i), &points[3 * i]);
  }
  const vtkNew<vtkCellArray> cells;
  cells->AllocateExact(static_cast<vtkIdType>(triangles.size() / 3), static_cast<vtkIdType>(triangles.size()));
  for (std::size_t i = 0; i < triangles.size(); i += 3) {
    const std::array<vtkIdType, 3> corners{triangles[i], triangles[i + 1], triangles[i + 2]};
    cells->InsertNextCell(3, corners.data());
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(rows);
  mesh->SetPolys(cells);
  return mesh;
}

std::vector<Point> ellipse(const SlideMark& slide) {
  std::vector<Point> points(kEllipseSegments);
  for (int i = 0; i < kEllipseSegments; ++i) {
    const double t = 2 * std::numbers::pi * i / kEllipseSegments;
    for (std::size_t k = 0; k < 3; ++k) {
      points[static_cast<std::size_t>(i)][k] = slide.center[k] + std::cos(t) * slide.u[k] + std::sin(t) * slide.v[k];
    }
  }
  return points;
}

std::vector<Point> rectangle(const std::array<double, 12>& corners) {
  std::vector<Point> points(4);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    points[i / 3][i % 3] = corners[i];
  }
  return points;
}

vtkSmartPointer<vtkPolyData> closed_lines(const std::vector<std::vector<Point>>& loops) {
  const vtkNew<vtkPoints> rows;
  rows->SetDataTypeToDouble();
  const vtkNew<vtkCellArray> cells;
  for (const auto& loop : loops) {
    const vtkIdType first = rows->GetNumberOfPoints();
    cells->InsertNextCell(static_cast<int>(loop.size()) + 1);
    for (const Point& point : loop) {
      cells->InsertCellPoint(rows->InsertNextPoint(point.data()));
    }
    cells->InsertCellPoint(first);
  }
  auto lines = vtkSmartPointer<vtkPolyData>::New();
  lines->SetPoints(rows);
  lines->SetLines(cells);
  return lines;
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
  lines->SetOutput(closed_lines(loops));
  return tubes(*lines, radius, color);
}

vtkSmartPointer<vtkActor> model_actor(const PictureInput& input) {
  const vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(surface(input.model_points, input.model_triangles));
  normals->SetFeatureAngle(kCreaseAngle);
  normals->ConsistencyOff();
  auto actor = actor_of(*normals, kModelGrey);
  actor->GetProperty()->SetOpacity(0.55);
  actor->GetProperty()->SetAmbient(0.15);
  actor->GetProperty()->SetDiffuse(0.85);
  return actor;
}

void add_cage(const PictureInput& input, double pixel, std::vector<vtkSmartPointer<vtkActor>>& actors) {
  const auto mesh = surface(input.cage_points, input.cage_triangles);
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
