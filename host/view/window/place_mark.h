// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_VIEW_WINDOW_PLACE_MARK_H
#define CAGEWRIGHT_HOST_VIEW_WINDOW_PLACE_MARK_H

#include <vtkActor2D.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper2D.h>

#include <Eigen/Core>
#include <array>
#include <optional>

#include "host/view/window/scene_view.h"

namespace cagewright::host {

// A ring with a cross round one place, in the failed slides' colour on a dark rim, over all that is drawn: where a
// problem is. Its size is in pixels.
class PlaceMark {
 public:
  explicit PlaceMark(vtkRenderer& renderer);
  ~PlaceMark();
  PlaceMark(const PlaceMark&) = delete;
  PlaceMark& operator=(const PlaceMark&) = delete;

  void set(const std::optional<Point3>& place);  // empty: none
  // To where the camera now sees it. Before each frame.
  void follow(const Eigen::Matrix4d& to_scene);

 private:
  struct Outline {
    vtkNew<vtkPolyDataMapper2D> mapper;
    vtkNew<vtkActor2D> actor;
  };

  vtkRenderer& renderer_;
  std::optional<Point3> place_;
  double ratio_ = 0;                 // of which the shape is
  std::array<Outline, 2> outlines_;  // the rim, and on it the mark
};

}  // namespace cagewright::host

#endif
