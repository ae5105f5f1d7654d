// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_VALIDATE_MODEL_CHECKS_H
#define CAGEWRIGHT_HOST_VALIDATE_MODEL_CHECKS_H

#include "host/file/triangle_mesh.h"
#include "host/validate/check.h"
#include "host/validate/observed_cage.h"

namespace cagewright::host {

// The cut model is the model that was given: its volume and area are the same, and what was added lies on the planes of
// slides. is_turned: the plug-in had to turn some of the model's triangles, so that it has no volume as it was given.
// O(n log n).
Check check_segmentation(const ObservedCage& seen, const TriangleMesh& model, bool is_turned);

// Where the plug-in says that the cage encloses the model: the cage winds round every vertex of the cut model, by solid
// angles. Floating point, no more than a second opinion. O(vertices x cage triangles).
Check check_enclosing(const ObservedCage& seen);

}  // namespace cagewright::host

#endif
