// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/mesh/half_edge_mesh.h"
#include "core/tests/random_numbers.h"

// For tests of slides that are a point of the surface.
namespace cagewright {

// Within a random triangle; all are as likely.
Vector3 random_point_on(const HalfEdgeMesh& mesh, Random& random);

// Of a closed polygon to a point.
double distance_to(const Points& loop, const Vector3& point);

// Radians, at most a right angle.
double angle_between_lines(const Vector3& a, const Vector3& b);

}  // namespace cagewright
