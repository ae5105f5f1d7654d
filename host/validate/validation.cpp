// SPDX-License-Identifier: BSD-3-Clause
#include "host/validate/validation.h"

#include <algorithm>
#include <iterator>

#include "host/plugin_client/plugin_error.h"
#include "host/validate/equation_8.h"
#include "host/validate/model_checks.h"
#include "host/validate/observed_cage.h"
#include "host/validate/refinement_checks.h"

namespace cagewright::host {

bool Validation::agrees() const {
  return std::all_of(checks.begin(), checks.end(), [](const Check& check) { return check.holds(); });
}

Validation validate(const Plugin& plugin, const Session& session, const TriangleMesh& model,
                    const ValidationOptions& options, const ValidationProgress& progress) {
  const auto now = [&](double fraction, const char* what) {
    if (progress && !progress(fraction, what)) throw Cancelled();
  };
  const ObservedCage seen = observe(session);
  Validation found;
  found.model_triangles = model.triangle_count();
  found.slides = seen.sections.size();
  found.cage_triangles = seen.triangles.size();
  found.iterations = seen.iterations.size();
  found.certified = seen.certified;
  found.volume_ratio = session.summary().volume_ratio;
  for (const ObservedIteration& iteration : seen.iterations) {
    found.max_signed_distances.push_back(iteration.max_signed_distance / seen.diagonal);
  }
  found.max_signed_distances.push_back(seen.max_signed_distance / seen.diagonal);

  now(0, "check orient");
  const cgw_mesh_report report = session.mesh_report();
  const bool is_turned = report.turned_triangles > 0 && report.turned_triangles < report.triangles;
  found.checks.push_back(check_segmentation(seen, model, is_turned));
  OrientationReport orientation = check_orientation(seen, options.starts);
  found.orientation = orientation.figures;
  std::move(orientation.checks.begin(), orientation.checks.end(), std::back_inserter(found.checks));
  now(0.1, "check refine");
  std::vector<Check> refinement = check_refinement(seen);
  std::move(refinement.begin(), refinement.end(), std::back_inserter(found.checks));
  found.checks.push_back(check_equation_8(seen));
  now(0.2, "check enclose");
  found.checks.push_back(check_enclosing(seen));
  if (options.seconds > 0 && seen.certified) {
    now(0.25, "tighten by Ceres");
    const auto goes_on = [&](double fraction) {
      return !progress || progress(0.25 + 0.75 * fraction, "tighten by Ceres");
    };
    found.optimality = find_optimality(plugin, seen, model, options.seconds, options.threads, goes_on);
  }
  now(1, "write");
  return found;
}

}  // namespace cagewright::host
