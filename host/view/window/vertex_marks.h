// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_VIEW_WINDOW_VERTEX_MARKS_H
#define CAGEWRIGHT_HOST_VIEW_WINDOW_VERTEX_MARKS_H

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>

#include <vector>

#include "host/view/window/scene_view.h"

namespace cagewright::host {

// Dots of a few pixels at single vertices, which alone would be too small to see on a fine mesh.
class VertexMarks {
 public:
  explicit VertexMarks(vtkRenderer& renderer);
  ~VertexMarks();
  VertexMarks(const VertexMarks&) = delete;
  VertexMarks& operator=(const VertexMarks&) = delete;

  void set(const std::vector<Point3>& points);
  void set_transform(const Matrix4& to_scene);
  void set_visible(bool visible);
  void set_pixel_ratio(double ratio);

 private:
  vtkRenderer& renderer_;
  vtkNew<vtkPolyDataMapper> mapper_;
  vtkNew<vtkActor> actor_;
};

}  // namespace cagewright::host

#endif
