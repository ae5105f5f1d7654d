// SPDX-License-Identifier: BSD-3-Clause
#include "host/workspace/describe_run.h"

#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace cagewright::host {
namespace {

// NaN is the plug-in's word for "not computed".
std::optional<double> known(double figure) {
  return std::isfinite(figure) ? std::optional<double>(figure) : std::nullopt;
}

std::optional<std::int64_t> known_genus(std::int64_t genus) {
  return genus >= 0 ? std::optional<std::int64_t>(genus) : std::nullopt;
}

RunOptions with_parameters(RunOptions options, const Plugin& plugin, const Session& session) {
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

Report::Option option_value(const Parameter& parameter, double value) {
  if (parameter.type == CGW_PARAM_BOOLEAN) return value != 0;
  if (parameter.type == CGW_PARAM_INTEGER) return static_cast<std::int64_t>(value);
  if (parameter.type == CGW_PARAM_CHOICE && value >= 0 && value < static_cast<double>(parameter.choices.size())) {
    return parameter.choices[static_cast<std::size_t>(value)];
  }
  return value;
}

Report::Certificate describe_certificate(const Certificate& certificate) {
  static constexpr std::size_t most_listed = 100;
  const auto first = [](const auto& list) {
    return std::vector(list.begin(), list.begin() + static_cast<std::ptrdiff_t>(std::min(list.size(), most_listed)));
  };
  Report::Certificate report;
  report.closed = certificate.closed;
  report.self_intersections = certificate.self_intersections.size();
  report.model_cage_intersections = certificate.model_cage_intersections.size();
  report.vertices_outside = certificate.vertices_outside.size();
  report.encloses = certificate.encloses;
  report.degenerate_triangles = certificate.degenerate_triangles.size();
  report.keeps_distance = certificate.keeps_distance;
  report.message = certificate.message;
  report.first_degenerate_triangles = first(certificate.degenerate_triangles);
  report.first_vertices_outside = first(certificate.vertices_outside);
  report.first_self_intersections = first(certificate.self_intersections);
  report.first_model_cage_intersections = first(certificate.model_cage_intersections);
  return report;
}

Report::Tightness describe_tightness(const Measures& measures) {
  return {known(measures.volume_ratio), known(measures.mean_gap), known(measures.max_gap), known(measures.clearance),
          known(measures.coverage)};
}

Report::Quality describe_quality(const Measures& measures) {
  return {known(measures.least_dihedral),  known(measures.greatest_dihedral), known(measures.greatest_aspect),
          known(measures.mean_asymmetry),  known(measures.max_asymmetry),     known(measures.worst_squareness),
          known(measures.worst_planarity), known(measures.worst_twist)};
}

Report::Mesh describe_mesh(const cgw_mesh_report& report) {
  return {report.vertices, report.triangles, report.components, known_genus(report.genus), report.closed == 1};
}

Report describe_run(RunOptions options, const Plugin& plugin, const Session& session, const TriangleMesh& cage,
                    const cgw_mesh_report& cage_report) {
  const cgw_mesh_report model = session.mesh_report();
  const cgw_summary summary = session.summary();
  Report report;
  report.model = describe_mesh(model);
  report.slides = describe_slides(plugin, session);
  report.parts = session.part_count();
  report.cage = {cage.vertex_count(), cage.triangle_count(), known_genus(cage_report.genus)};
  report.refinement = describe_refinement(session, summary, model.diagonal);
  report.certificate = describe_certificate(session.certificate());
  const Measures measures = session.measures();
  report.tightness = describe_tightness(measures);
  report.quality = describe_quality(measures);
  report.timings_ms.segment = known(summary.segment_ms);
  report.timings_ms.orient = known(summary.orient_ms);
  report.timings_ms.meshing = known(summary.meshing_ms);
  report.timings_ms.refine = known(summary.refine_ms);
  report.timings_ms.enclose = known(summary.enclose_ms);
  report.version = CAGEWRIGHT_VERSION;
  report.options = with_parameters(std::move(options), plugin, session);
  return report;
}

double peak_memory_mb() {
  struct rusage usage {};
  ::getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;  // Linux counts KiB
}

}  // namespace cagewright::host
