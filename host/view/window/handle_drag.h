// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_VIEW_WINDOW_HANDLE_DRAG_H
#define CAGEWRIGHT_HOST_VIEW_WINDOW_HANDLE_DRAG_H

#include <Eigen/Core>
#include <optional>
#include <utility>
#include <vector>

#include "host/view/window/handle_shapes.h"
#include "host/view/window/projection.h"

namespace cagewright::host {

using SlideEllipses = std::vector<std::pair<std::int64_t, Slide::Ellipse>>;

// Where handles stand: an orthonormal frame in the active mesh's space.
struct HandleFrame {
  Eigen::Vector3d center;
  Eigen::Matrix3d axes;  // columns u, v, normal
};

// Of an ellipse; empty where it has no plane or is not finite.
std::optional<HandleFrame> handle_frame(const Slide::Ellipse& ellipse);

// One drag of one handle: what mouse positions make of the slides at its beginning. No VTK. Where a mouse position
// means nothing (it is past the horizon of the plane or line that is dragged along), the last that meant something
// holds; and nothing moves farther than ten times what the mouse's way is worth on the screen, however flat it is seen.
class HandleDrag {
 public:
  struct Begin {
    SlideHandles::Mode mode = SlideHandles::Mode::none;
    HandleWay way = HandleWay::u;
    HandleFrame frame;
    SlideEllipses slides;
    Eigen::Matrix4d to_scene;  // invertible
    double length = 1;         // of an arrow, pixels
    double x = 0, y = 0;       // of the mouse
  };
  HandleDrag(const Begin& begin, const Projection& projection);

  SlideEllipses to(double x, double y, bool snap);

 private:
  double handle_length() const;               // scene units
  double farthest(double x, double y) const;  // that a drag from the beginning to here may move, scene units
  std::optional<double> on_axis(double x, double y) const;
  std::optional<Eigen::Vector3d> on_plane(double x, double y) const;
  std::optional<double> angle_at(double x, double y) const;
  double way_along_axis(double x, double y);         // scene units
  Eigen::Vector3d way_in_plane(double x, double y);  // scene space
  double angle_turned(double x, double y);
  double factor(double x, double y);

  Begin begin_;
  Projection projection_;
  Eigen::Matrix3d linear_;  // of to_scene
  Eigen::Matrix4d from_scene_;
  Eigen::Vector3d center_;         // of the handles, scene space
  Eigen::Vector3d axis_in_mesh_;   // of u, v or normal; unit
  Eigen::Vector3d axis_, normal_;  // scene space, unit: dragged along; of the plane dragged in
  bool is_edge_on_ = false;        // a ring seen from its side: pixels along it count
  std::optional<double> begin_on_axis_;
  std::optional<Eigen::Vector3d> begin_on_plane_;
  double way_ = 0;                                          // the last that meant something
  Eigen::Vector3d way_in_plane_ = Eigen::Vector3d::Zero();  // likewise
  double last_angle_ = 0, turned_ = 0;                      // radians; turns are counted
};

}  // namespace cagewright::host

#endif
