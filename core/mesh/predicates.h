// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/mesh/types.h"

namespace cagewright {

// Sign (-1, 0, 1) of det[b-a, c-a, d-a]: 1 where d lies on the side of triangle abc to which its counter-clockwise
// normal points. Exact for all finite doubles without overflow or underflow: a floating-point filter, then rationals.
int orient3d(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d);

// Sign of det[b-a, c-a]: 1 where abc runs counter-clockwise. Exact, as above.
int orient2d(const Vector2& a, const Vector2& b, const Vector2& c);

}  // namespace cagewright
