// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_WORKSPACE_TILTED_PLANE_H
#define CAGEWRIGHT_HOST_WORKSPACE_TILTED_PLANE_H

#include <functional>
#include <vector>

#include "host/file/slides_file.h"

namespace cagewright::host {

// What slide a plane gives; throws PluginError where none.
using FitPlane = std::function<Slide::Ellipse(const Slide::PointNormal&)>;

// The plane for a short stroke across a limb: that of slide_geometry.h, which holds the line of sight, too. But at a
// shoulder or an ear such a plane may run on along the body. Where its loop is more than 2.5 times as long as the
// stroke, in the stroke's direction, the plane is tilted about the stroke's middle, about the line of sight and about
// the stroke, by up to 30 degrees about each; the least tilted plane whose loop is about as long as the stroke (at
// most 1.5 times) is taken, and where there is none, that which was not tilted.
//
// Throws CommandError as plane_across does, and what `fit` throws of the plane that is not tilted, or of a tilted one
// where that is no PluginError about slides (no loop is there). At most 49 fits.
struct TiltedPlane {
  Slide::PointNormal plane;
  double tilt;  // radians from the plane that holds the line of sight; 0: it is that
};
TiltedPlane tilted_plane(const std::vector<Point3>& stroke, const Point3& line_of_sight, const FitPlane& fit);

}  // namespace cagewright::host

#endif
