// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/refine/refine.h"

namespace cagewright {

// Equation (8), damped: every cage vertex j moves to
//   argmin_x sum over t in F(j) of w_jt ((x - a_t) . n_t)^2 + mu_j |x - u_j|^2,  w_jt = f_t / |u_j - a_t|^2,
// with mu_j = damping_j * trace of the quadratic form, f_t = factors_t (all 1: the paper), and across plane_normal_j
// only where that is not zero. Reads before, plane_normal, normals and anchors of `record`; fills weights, damping and
// after. `smallest_distance` (> 0, model units) bounds w where an anchor is at the vertex itself. O(triangles).
void step_vertices(const Triangles& triangles, const std::vector<double>& factors, const std::vector<double>& damping,
                   double smallest_distance, RefineRecord& record);

}  // namespace cagewright
