// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_VIEW_WINDOW_HANDLE_SHAPES_H
#define CAGEWRIGHT_HOST_VIEW_WINDOW_HANDLE_SHAPES_H

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <Eigen/Core>
#include <vector>

#include "host/view/window/slide_handles.h"

namespace cagewright::host {

// What a handle is for. u, v and normal: along or about them; plane: in it (move) or both radii (scale); view: in the
// plane of the screen.
enum class HandleWay { u, v, normal, plane, view };

// A handle in its own space: x along u, y along v, z along the normal, 1 as long as an arrow.
struct HandleShape {
  HandleWay way = HandleWay::u;
  vtkSmartPointer<vtkPolyData> surface;
  std::vector<Eigen::Vector3d> outline;  // where the mouse takes it: within `reach` of this run of points
  double reach = 7;                      // pixels, before pixel_ratio()
  std::vector<Eigen::Vector3d> places;   // where to press, best first
  Point3 colour{};
};

// Move: u, v, normal, plane, view. Turn: u, v, normal. Scale: u, v, plane.
std::vector<HandleShape> handle_shapes(SlideHandles::Mode mode);

}  // namespace cagewright::host

#endif
