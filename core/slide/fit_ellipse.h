// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "core/slide/slide.h"

namespace cagewright {

// The paper's ellipse of a stroke (3.1): least-squares plane, projection, direct least-squares ellipse fit
// [Fitzgibbon et al. 1999, in the numerically stable form of Halir & Flusser 1998]. The normal's sign follows the
// direction in which the stroke runs, u points to the side of its first point.
// Throws Error: slide_not_finite (element = stroke point), stroke_too_short (fewer than 5 distinct points),
// stroke_collinear, stroke_no_ellipse. `name` is for the sentences. O(n).
Ellipse fit_stroke(const Points& stroke, const std::string& name);

// The ellipse with the second moments of the region inside a closed planar polygon (any winding), given as n x 3 points
// near the plane through `on_plane` with unit `normal`. Unlike a conic fit it exists for every loop with an area, and
// its centre is the region's centroid. u points to the side on which the region reaches farther. O(n).
// Throws Error(slide_degenerate) where the region has no area.
Ellipse fit_loop(const Points& loop, const Vector3& on_plane, const Vector3& normal, const std::string& name);

// The principal radii of the ellipse with conjugate radii u and v.
// Throws Error: slide_not_finite, slide_degenerate (zero or parallel radii). O(1).
Ellipse from_radii(const EllipseDefinition& definition, const std::string& name);

// Throws what makes a slide unusable whatever the model is. O(n).
void check_definition(const Slide& slide);

}  // namespace cagewright
