// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_VALIDATE_EQUATION_8_H
#define CAGEWRIGHT_HOST_VALIDATE_EQUATION_8_H

#include "host/validate/check.h"
#include "host/validate/observed_cage.h"

namespace cagewright::host {

// Equation (8) as the plug-in says that it solves it: cage vertex j goes to the least of
//   sum over its triangles t of w_jt ((x - a_t) . n_t)^2 + mu_j |x - u_j|^2,
// across plane_normal_j only where that is not zero; w, a, n, mu, u from the record. Ceres minimises it, vertex by
// vertex, with residuals that it differentiates itself. Throws std::runtime_error where Ceres finds no solution.
PointList minimise_equation_8(const std::vector<Corners>& triangles, const ObservedIteration& iteration, double scale);

// Every vertex of every iteration against the plug-in's, within 1e-9 of the diagonal.
Check check_equation_8(const ObservedCage& seen);

}  // namespace cagewright::host

#endif
