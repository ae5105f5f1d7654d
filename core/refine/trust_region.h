// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/refine/refine.h"

namespace cagewright {

// Takes the step of equation (8) with as much damping as it needs to be trusted: no triangle of the cage or of a
// section comes nearer than half way, or than tolerance::least_facing, to being seen edge-on from its part's centre,
// since the cones of the local scope, and so the next step, mean nothing beyond that. Starts from `damping` everywhere
// and raises it, vertex by vertex, where a triangle objects. Reads and fills `record` as step_vertices does.
// O(triangles * attempts).
void trusted_step(const Segmentation& segmentation, const Cage& cage, const std::vector<double>& factors,
                  double damping, double smallest_distance, RefineRecord& record);

}  // namespace cagewright
