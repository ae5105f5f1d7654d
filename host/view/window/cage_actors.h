// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_VIEW_WINDOW_CAGE_ACTORS_H
#define CAGEWRIGHT_HOST_VIEW_WINDOW_CAGE_ACTORS_H

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>

#include "host/view/window/line_actor.h"
#include "host/view/window/scene_view.h"

namespace cagewright::host {

// The cage: translucent faces, edges, and the sections' rectangles. What has not changed is not uploaded again.
class CageActors {
 public:
  explicit CageActors(vtkRenderer& renderer);
  ~CageActors();
  CageActors(const CageActors&) = delete;
  CageActors& operator=(const CageActors&) = delete;

  void set(const ShownCage* cage);  // null: none
  void set_transform(const Matrix4& to_scene);
  void set_options(const ViewOptions& options);
  void set_pixel_ratio(double ratio);

 private:
  void apply();

  vtkRenderer& renderer_;
  vtkNew<vtkPolyDataMapper> mapper_;
  vtkNew<vtkActor> faces_;
  LineActor edges_, sections_;
  TriangleMesh shown_;
  bool is_stale_ = false;
  ViewOptions options_;
};

}  // namespace cagewright::host

#endif
