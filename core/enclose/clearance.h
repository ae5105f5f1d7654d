// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <set>
#include <utility>

#include "core/enclose/outside.h"
#include "core/enclose/section_shape.h"
#include "core/error/error.h"
#include "core/meshing/meshing.h"

namespace cagewright {

struct ClearanceOptions {
  double wanted = 0;  // distance from the model, model units, above gap
  double gap = 0;     // between cage triangles, and from the model in any case
  double diagonal = 0;
  bool may_release = false;  // sections that cannot keep it in their planes may leave them
  unsigned threads = 0;
};

struct Clearance {
  std::vector<double> kept;  // of each cage triangle: its distance from the model, between gap and what is wanted
  int pushes = 0;            // steps of push_out
};

// Pushes a cage that encloses the model away from it, until it keeps the distance wanted or as much of it as it can.
// It encloses the model all the time. Where sections hold it back in their planes they may leave them, and go back as
// far as the distance lets them; those that do not get there are released. Throws Error(cancelled). The same
// for any number of threads.
Clearance keep_clearance(MovableCage& movable, SectionShape& shape, const VertexNeighbours& neighbours,
                         const std::vector<int>& vertex_owners, const ClearanceOptions& options,
                         const Progress& progress);

// Of each cage triangle the distance from the model, `most` where it is more than that.
std::vector<double> distances_kept(const MovableCage& movable, double most, unsigned threads);

// Where it keeps less than is wanted (kept: of each cage triangle).
struct TooNear {
  std::set<int> slides;                     // whose sections the triangles join, or whose limbs they cap
  std::set<std::pair<int, int>> conflicts;  // slides of limbs that may be in each other's way, the lower first
};

// Two limbs may be in each other's way where a triangle of one that is too near has model of the other within twice the
// distance wanted.
TooNear find_too_near(const MovableCage& movable, const std::vector<double>& kept, double wanted);

}  // namespace cagewright
