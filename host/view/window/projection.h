// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_VIEW_WINDOW_PROJECTION_H
#define CAGEWRIGHT_HOST_VIEW_WINDOW_PROJECTION_H

#include <Eigen/Geometry>
#include <array>

#include "host/view/window/scene_view.h"

class vtkRenderer;

namespace cagewright::host {

inline Eigen::Vector3d to_vector(const Point3& point) { return Eigen::Vector3d(point.data()); }
inline Point3 to_point(const Eigen::Vector3d& vector) { return {vector.x(), vector.y(), vector.z()}; }
inline Eigen::Matrix4d to_matrix(const Matrix4& rows) {
  return Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(rows.data());
}
inline Eigen::Vector3d transformed(const Eigen::Matrix4d& matrix, const Eigen::Vector3d& point) {
  return (matrix * point.homogeneous()).head<3>();
}

// A line of sight in the scene's space; direction unit.
struct SightLine {
  Eigen::Vector3d origin, direction;
};

// A renderer's camera as it is now, as plain numbers. Copy; cheap to make.
struct Projection {
  explicit Projection(vtkRenderer& renderer);

  Eigen::Vector3d eye, focal_point;
  Eigen::Vector3d right, up, forward;  // orthonormal
  std::array<double, 2> origin{};      // of the renderer in the window, pixels
  std::array<double, 2> size{1, 1};    // pixels
  bool is_orthographic = false;
  // Half of the window's height in scene units: everywhere (orthographic), or at distance 1 along forward.
  double half_height = 1;
  double near_depth = 0;  // distance along forward from the eye to what is nearest drawn

  struct Seen {
    double x = 0, y = 0;      // display coordinates
    double depth = 0;         // along forward from the eye, scene units
    bool is_visible = false;  // in front of the eye; else x and y mean nothing
  };
  Seen see(const Eigen::Vector3d& point) const;
  SightLine sight_line(double x, double y) const;
  // Scene units that a pixel is worth at the depth of a point; > 0.
  double pixel_at(const Eigen::Vector3d& point) const;
  double pixel_at_depth(double depth) const;
};

// Device pixels per pixel of the design, from the window's DPI (72: 1). Line widths and sizes are multiplied with it.
double pixel_ratio(vtkRenderer& renderer);

}  // namespace cagewright::host

#endif
