// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "core/measure/measured_model.h"

namespace cagewright {

// A plane that a model is its own mirror image in, nearly.
struct MirrorPlane {
  Vector3 point, normal;  // model units; the normal is unit
  double deviation;       // mean distance between the model and its mirror image, over the diagonal
};

// The mirror planes of a model, at most tolerance::mirror from true. A mirror plane holds the centroid of the surface
// and is normal to a principal axis of it; tried are the planes through the centroid normal to the coordinate axes,
// then to the principal ones. Where two principal moments are equal, as on bodies of revolution and cubes, any
// direction between their axes is principal: of such a model in a turned position planes may be missed, never invented.
// Looks at about 8,000 points at most. Same bits for any number of threads (0: all). O(points * log n).
std::vector<MirrorPlane> find_mirror_planes(const MeasuredModel& model, unsigned threads = 0);

// How much a cage differs between the two sides of a plane.
struct Asymmetry {
  double mean, max;  // distance from points of the mirrored cage (SurfaceSamples) to the cage, over the diagonal
};

// The greater of each figure over the planes; empty where there is no plane. Precondition: at least one cage triangle.
// Same bits for any number of threads (0: all). O(planes * c log c), c = cage triangles.
std::optional<Asymmetry> measure_asymmetry(const MeasuredModel& model, const std::vector<MirrorPlane>& planes,
                                           const IndexedMesh& cage, unsigned threads = 0);

}  // namespace cagewright
