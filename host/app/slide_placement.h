// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_APP_SLIDE_PLACEMENT_H
#define CAGEWRIGHT_HOST_APP_SLIDE_PLACEMENT_H

#include "host/file/slides_file.h"

namespace cagewright::host {

// A slide in the numbers of an attribute editor: the transform that takes the unit circle of the x-y plane to it, as
// animation programs write one. Degrees about x, then y, then z.
struct SlidePlacement {
  Point3 translate{}, rotate{};
  double radius_u = 1, radius_v = 1;
};

// Radii that are not at right angles are taken by their lengths and by v's direction across u.
SlidePlacement placement_of(const Slide::Ellipse& ellipse);
Slide::Ellipse ellipse_of(const SlidePlacement& placement);

}  // namespace cagewright::host

#endif
