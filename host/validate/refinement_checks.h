// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_VALIDATE_REFINEMENT_CHECKS_H
#define CAGEWRIGHT_HOST_VALIDATE_REFINEMENT_CHECKS_H

#include <vector>

#include "host/validate/check.h"
#include "host/validate/observed_cage.h"

namespace cagewright::host {

// What goes into equation (8), computed again from the cut model and the cage's vertices before each step, as
// docs/algorithms/refinement.md defines it: normals, signed distances (6), anchors (7), weights, damping, the planes of
// sections; that each step starts where the one before ended; and what (9) says of the end. Nothing here is shared with
// the plug-in. O(iterations x vertices of the cut model).
std::vector<Check> check_refinement(const ObservedCage& seen);

// (6) at one iteration: no vertex of the model that a triangle has to clear is farther out than the one it names. With
// the local scope these are the vertices of its part that the part's centre sees through it and through no other, and
// the one that it names has to be seen through it, too. Part of check_refinement.
void check_outermost(const ObservedCage& seen, const ObservedIteration& iteration, const std::string& where,
                     Check& missed, Check& stray);

}  // namespace cagewright::host

#endif
