// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/meshing/bound.h"

namespace cagewright {

// How well `center` sees the bounds of a part, in [-1, 1]: the least of
// - the sine of the angle at which it sees any corner above that bound's plane, from inside;
// - the sine of the angle between any two bounds, or a bound and a free corner, as seen from it (negative: they
// overlap);
// - how far it lies inside the convex hull of all corners, over the distance to the farthest corner.
// Positive: the bounds lie side by side on a sphere round it and the corners surround it. O(bounds^2).
double visibility(const Bounds& bounds, const Vector3& center);

// The centre of projection of 3.3: about the point of greatest visibility. A pattern search from the mean of all
// corners (the paper: of the bounds' centres) finds it roughly; Newton's method on a smooth stand-in makes it a point
// that moves with the model to the last few bits. `part` and the slides' `names` are for the sentence. Throws
// Error(sections_overlap) where no point is found with a visibility above tolerance::least_visibility, as between
// sections in one plane. O(bounds^2).
Vector3 projection_center(const Bounds& bounds, std::size_t part, const std::vector<std::string>& names);

// The same point, or nothing where that would throw or the point sees two corners in one direction.
std::optional<Vector3> find_projection_center(const Bounds& bounds);

}  // namespace cagewright
