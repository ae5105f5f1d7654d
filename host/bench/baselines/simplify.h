// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "host/bench/baselines/surface.h"

namespace cagewright::bench {

enum class Collapse { lindstrom_turk, quadrics };

// The surface after edge collapses, in the order of what each costs, down to that many triangles or as few as the
// surface's topology lets it have. The surface has to be closed and manifold.
Surface simplified(Surface surface, std::size_t triangles, Collapse collapse);

constexpr const char* name_of(Collapse collapse) {
  return collapse == Collapse::lindstrom_turk ? "Lindstrom-Turk" : "quadrics";
}

}  // namespace cagewright::bench
