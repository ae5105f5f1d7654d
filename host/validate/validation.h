// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_VALIDATE_VALIDATION_H
#define CAGEWRIGHT_HOST_VALIDATE_VALIDATION_H

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "host/plugin_client/session.h"
#include "host/validate/check.h"
#include "host/validate/optimality.h"
#include "host/validate/orientation_checks.h"

namespace cagewright::host {

struct ValidationOptions {
  std::size_t starts = 200;   // random ones, of the search over equation (1)
  double seconds = 120;       // for the search of a tighter cage; 0: none
  std::uint32_t threads = 0;  // of the plug-in's certificates; 0: all
};

// What was found of one cage.
struct Validation {
  std::string node;  // of the scene; "" where there is but one model
  std::size_t model_triangles = 0, slides = 0, cage_triangles = 0, iterations = 0;
  double volume_ratio = 0;  // as the plug-in says
  bool certified = false;
  std::vector<double> max_signed_distances;  // over the diagonal: before each iteration, and of the refined cage
  std::vector<Check> checks;                 // in the order of the stages
  OrientationFigures orientation;
  std::optional<Optimality> optimality;  // where it was asked for and the cage is certified

  bool agrees() const;
};

// Told what is being done; returns false to cancel.
using ValidationProgress = std::function<bool(double fraction, const std::string& what)>;

// Checks the session's last solve on `model`. Deterministic but for the search of a tighter cage, which ends by the
// clock. Throws PluginError, Cancelled, and std::runtime_error where Ceres fails.
Validation validate(const Plugin& plugin, const Session& session, const TriangleMesh& model,
                    const ValidationOptions& options, const ValidationProgress& progress);

}  // namespace cagewright::host

#endif
