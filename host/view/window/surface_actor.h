// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_VIEW_WINDOW_SURFACE_ACTOR_H
#define CAGEWRIGHT_HOST_VIEW_WINDOW_SURFACE_ACTOR_H

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkSmartPointer.h>

#include <cstddef>
#include <cstdint>
#include <vector>

#include "host/view/window/scene_view.h"

namespace cagewright::host {

// Above, normals are left to the graphics card, a triangle each.
constexpr std::size_t kMostSmoothTriangles = 200'000;

// A mesh as a shaded surface: smooth up to a crease angle. The mesh itself is not kept.
class SurfaceActor {
 public:
  explicit SurfaceActor(const TriangleMesh& mesh);

  vtkActor& actor() const { return *actor_; }
  void set_transform(const Matrix4& to_scene);
  void set_colour(const Point3& colour);
  void set_wireframe(bool wireframe);

  // A colour of its own for each triangle, or for each vertex of the mesh; of this many.
  void set_triangle_colours(const std::vector<Point3>& colours);
  void set_vertex_colours(const std::vector<Point3>& colours);
  void show_own_colours(bool shown);

 private:
  vtkNew<vtkPolyDataMapper> mapper_;
  vtkNew<vtkActor> actor_;
  vtkSmartPointer<vtkPolyData> drawn_;
  std::vector<std::uint32_t> triangles_;  // of the mesh, for each cell of drawn_
  vtkSmartPointer<vtkPolyData> wires_;    // the edges of drawn_, with its points and their data; null until it is shown
  bool has_triangle_colours_ = false;
  bool is_reversed_ = false;  // the triangles of drawn_ are clockwise
};

}  // namespace cagewright::host

#endif
