// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_VIEW_WINDOW_CAMERA_CONTROL_H
#define CAGEWRIGHT_HOST_VIEW_WINDOW_CAMERA_CONTROL_H

#include <array>

#include "host/file/slides_file.h"

class vtkRenderer;

namespace cagewright::host {

// Maya's camera: tumble about the centre of interest (azimuth about the world's up, elevation), track in the view's
// plane, dolly along the view. All in pixels of the window, x to the right and y up, as VTK's display coordinates.
// The camera never rolls: its right stays level; past a pole it hangs upside down. Every function but the questions
// leaves clipping up to date. Main thread only (VTK).
class CameraControl {
 public:
  // Looks from the first view (Axis::perspective) at the origin.
  explicit CameraControl(vtkRenderer& renderer);

  void tumble(double dx, double dy);
  void track(double dx, double dy);                // what is under the mouse at the centre's depth stays under it
  void dolly(double pixels);                       // > 0: nearer
  void zoom_at(double steps, double x, double y);  // the wheel's, > 0: nearer; what is under the mouse stays there

  // Moves so that the bounds {x0, x1, y0, y1, z0, z1} fill the window; the direction stays.
  void frame(const std::array<double, 6>& bounds);
  enum class Axis { front, back, left, right, top, bottom, perspective };  // perspective: the first view
  // Centre and distance stay, and whether it is orthographic.
  void look_along(Axis axis);
  void look_from(const Point3& toward_viewer);  // unit; likewise
  void set_orthographic(bool orthographic);     // what is at the centre keeps its size
  bool is_orthographic() const;
  void turn(double degrees);  // about the world's up, through the centre of interest: turntables
  void set_up(const Point3& up);
  // After what is in the renderer has changed, or parts would be cut off.
  void update_clipping();

 private:
  vtkRenderer& renderer_;
  Point3 up_{0, 1, 0};
};

}  // namespace cagewright::host

#endif
