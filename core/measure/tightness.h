// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "core/enclose/certificate.h"
#include "core/measure/measured_model.h"

namespace cagewright {

// How closely a cage fits. Lengths are fractions of the diagonal of the model's bounding box.
struct Tightness {
  // Signed volume of the cage over the model's: negative where the cage faces inward. Empty where the cage is not
  // closed or not consistently oriented, after welding by position.
  std::optional<double> volume_ratio;
  // Distance from points of the cage to the model's surface, unsigned: the mean by the cage's area, and the largest.
  // The points are those of SurfaceSamples, 78 on each cage triangle (fewer on cages of more than 2,564 triangles).
  double mean_gap = 0, max_gap = 0;
  double clearance = 0;  // least distance between cage and model, triangle to triangle; 0 where they meet
  // Share of the model's vertices that the cage winds round, exactly, each by a third of the area of the triangles at
  // it: 1 where all are inside. Empty as volume_ratio is.
  std::optional<double> coverage;
};

// `certificate` is certify's of this model, as MeasuredModel was given it, and this cage: it tells what meets and what
// is outside, so that nothing is tested twice. Precondition: those of certify, and a cage that is not all degenerate.
// Throws Error: those of weld, for the cage. Threads: 0 for all; same bits for any number. Thread-safe. O(c log n) for
// what does not meet, c = cage triangles.
Tightness measure_tightness(const MeasuredModel& model, const IndexedMesh& cage, const Certificate& certificate,
                            unsigned threads = 0);

}  // namespace cagewright
