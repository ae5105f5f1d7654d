// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "core/measure/cage_shape.h"
#include "core/measure/symmetry.h"
#include "core/measure/tightness.h"

namespace cagewright {

// All that can be measured of a cage, whoever made it. Sections: section_quality.h.
struct CageMeasures {
  Tightness tightness;
  CageShape shape;
  std::optional<Asymmetry> asymmetry;  // where the model is symmetric
};

// `certificate` is certify's of the same meshes. Preconditions: those of certify; no two model vertices at the same
// position. Threads: 0 for all; same bits for any number. Throws Error: those of weld, for the cage; mesh_empty where
// the model's triangles enclose no volume. Thread-safe. O((n + c) log n).
CageMeasures measure_cage(const IndexedMesh& model, const IndexedMesh& cage, const Certificate& certificate,
                          unsigned threads = 0);

}  // namespace cagewright
