// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_WORKSPACE_SLIDE_GEOMETRY_H
#define CAGEWRIGHT_HOST_WORKSPACE_SLIDE_GEOMETRY_H

#include <vector>

#include "host/file/slides_file.h"

namespace cagewright::host {

// Unit, along u x v.
Point3 normal_of(const Slide::Ellipse& ellipse);

Slide::Ellipse moved(const Slide::Ellipse& ellipse, const Point3& by);
// About its centre, right-handed about `axis` (of any length, not zero), radians.
Slide::Ellipse turned(const Slide::Ellipse& ellipse, const Point3& axis, double angle);
Slide::Ellipse scaled(const Slide::Ellipse& ellipse, double along_u, double along_v);

// On the other side of the plane x, y or z (axis 0, 1, 2) = at. The normal is mirrored, too.
Point3 mirrored(const Point3& point, int axis, double at);
Slide::Ellipse mirrored(const Slide::Ellipse& ellipse, int axis, double at);

// The plane that holds the line of sight (of any length) and, by least squares, the stroke; through the point of the
// stroke that is nearest to its middle by length. Throws CommandError where the stroke has no direction across the line
// of sight.
Slide::PointNormal plane_across(const std::vector<Point3>& stroke, const Point3& line_of_sight);

}  // namespace cagewright::host

#endif
