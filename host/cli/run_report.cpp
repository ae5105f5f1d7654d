// SPDX-License-Identifier: BSD-3-Clause
#include "host/cli/run_report.h"

#include <sys/resource.h>

#include <cmath>

namespace cagewright::host {
namespace {

// NaN is the plug-in's word for "not computed".
std::optional<double> known(double figure) {
  return std::isfinite(figure) ? std::optional<double>(figure) : std::nullopt;
}

std::optional<std::int64_t> known_genus(std::int64_t genus) {
  return genus >= 0 ? std::optional<std::int64_t>(genus) : std::nullopt;
}

Report::Option option_value(const Parameter& parameter, double value) {
  if (parameter.type == CGW_PARAM_BOOLEAN) return value != 0;
  if (parameter.type == CGW_PARAM_INTEGER) return static_cast<std::int64_t>(value);
  if (parameter.type == CGW_PARAM_CHOICE && value >= 0 && value < static_cast<double>(parameter.choices.size())) {
    return parameter.choices[static_cast<std::size_t>(value)];
  }
  return value;
}

std::vector<std::pair<std::string, Report::Option>> describe_options(const CageCommand& command, const Plugin& plugin,
                                                                     const Session& session) {
  std::vector<std::pair<std::string, Report::Option>> options;
  options.emplace_back("model", command.model.string());
  if (command.slides) options.emplace_back("slides", command.slides->string());
  if (command.out) options.emplace_back("out", command.out->string());
  options.emplace_back("threads", static_cast<std::int64_t>(command.threads));
  for (const Parameter& parameter : plugin.parameters()) {
    options.emplace_back(parameter.id, option_value(parameter, session.parameter(parameter.id)));
  }
  return options;
}

std::vector<Report::Slide> describe_slides(const Plugin& plugin, const Session& session) {
  std::vector<Report::Slide> slides;
  for (const SlideInfo& slide : session.slides()) {
    slides.push_back({slide.name, plugin.status_name(slide.info.status), slide.message});
  }
  return slides;
}

Report::Refinement describe_refinement(const Session& session, const cgw_summary& summary, double diagonal) {
  Report::Refinement refinement;
  refinement.iterations = summary.iterations;
  refinement.converged = summary.converged == 1;
  for (const double distance : session.max_signed_distances()) {
    refinement.max_signed_distance_over_diagonal.push_back(known(distance / diagonal));
  }
  refinement.max_signed_distance_over_diagonal.push_back(known(summary.max_signed_distance_over_diagonal));
  return refinement;
}

}  // namespace

Report::Mesh describe_mesh(const cgw_mesh_report& report) {
  return {report.vertices, report.triangles, report.components, known_genus(report.genus), report.closed == 1};
}

Report describe_run(const CageCommand& command, const Plugin& plugin, const Session& session, const TriangleMesh& cage,
                    const cgw_mesh_report& cage_report) {
  const cgw_mesh_report model = session.mesh_report();
  const cgw_summary summary = session.summary();
  Report report;
  report.model = describe_mesh(model);
  report.slides = describe_slides(plugin, session);
  report.parts = session.part_count();
  report.cage = {cage.vertex_count(), cage.triangle_count(), known_genus(cage_report.genus)};
  report.refinement = describe_refinement(session, summary, model.diagonal);
  report.certificate.closed = is_closed_manifold(cage_report);
  report.tightness.volume_ratio = known(summary.volume_ratio);
  report.timings_ms.segment = known(summary.segment_ms);
  report.timings_ms.orient = known(summary.orient_ms);
  report.timings_ms.meshing = known(summary.meshing_ms);
  report.timings_ms.refine = known(summary.refine_ms);
  report.version = CAGEWRIGHT_VERSION;
  report.options = describe_options(command, plugin, session);
  return report;
}

double peak_memory_mb() {
  struct rusage usage {};
  ::getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;  // Linux counts KiB
}

}  // namespace cagewright::host
