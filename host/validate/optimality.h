// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_VALIDATE_OPTIMALITY_H
#define CAGEWRIGHT_HOST_VALIDATE_OPTIMALITY_H

#include <cstdint>
#include <functional>
#include <vector>

#include "host/plugin_client/plugin.h"
#include "host/validate/observed_cage.h"

namespace cagewright::host {

// What a slow, general optimiser made of a certified cage, its triangles kept.
struct TighterCage {
  double volume_ratio = 0;    // cage over model, of a cage that the plug-in certifies
  double gap = 0;             // the plug-in's volume over this one's, less 1
  std::size_t rounds = 0;     // of contacts found, problem solved, certificate asked for
  std::size_t certified = 0;  // of them: what Ceres found was certified, wholly or on the way there
  double seconds = 0;
  bool settled = false;          // it ended because nothing was left to gain, not by the clock
  std::vector<double> vertices;  // n x 3
};

struct Optimality {
  double volume_ratio = 0;  // of the plug-in's cage
  TighterCage shaped;       // sections that are in their planes stay there, their angles within enclose.corner_angle
  TighterCage free;         // every vertex goes where it likes
};

// Minimises the volume of the certified cage under the conditions that it goes round the model and does not meet
// itself, as penalties that are tightened, by Ceres; every cage that counts is certified by the plug-in. Half of
// `seconds` for each of the two. `goes_on` is told the fraction done and returns false to cancel. Throws Cancelled,
// PluginError.
Optimality find_optimality(const Plugin& plugin, const ObservedCage& seen, const TriangleMesh& model, double seconds,
                           std::uint32_t threads, const std::function<bool(double)>& goes_on);

}  // namespace cagewright::host

#endif
