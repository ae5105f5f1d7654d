// SPDX-License-Identifier: BSD-3-Clause
#include "host/file/report_file.h"

#include <nlohmann/json.hpp>

namespace cagewright::host {
namespace {

using Json = nlohmann::ordered_json;

template <class Value>
Json or_null(const std::optional<Value>& value) {
  return value ? Json(*value) : Json(nullptr);  // NaN and infinity are dumped as null
}

Json to_json(const Report::Mesh& mesh) {
  return {{"vertices", or_null(mesh.vertices)},
          {"triangles", or_null(mesh.triangles)},
          {"components", or_null(mesh.components)},
          {"genus", or_null(mesh.genus)},
          {"closed", or_null(mesh.closed)}};
}

Json to_json(const std::vector<Report::Slide>& slides) {
  Json json = Json::array();
  for (const Report::Slide& slide : slides) {
    json.push_back({{"name", slide.name}, {"status", slide.status}, {"message", slide.message}});
  }
  return json;
}

Json to_json(const Report::Refinement& refinement) {
  Json distances = Json::array();
  for (const auto& distance : refinement.max_signed_distance_over_diagonal) distances.push_back(or_null(distance));
  return {{"iterations", or_null(refinement.iterations)},
          {"converged", or_null(refinement.converged)},
          {"max_signed_distance_over_diagonal", distances}};
}

Json to_json(const Report::Certificate& certificate) {
  return {{"closed", or_null(certificate.closed)},
          {"self_intersections", or_null(certificate.self_intersections)},
          {"model_cage_intersections", or_null(certificate.model_cage_intersections)},
          {"vertices_outside", or_null(certificate.vertices_outside)},
          {"encloses", or_null(certificate.encloses)},
          {"degenerate_triangles", or_null(certificate.degenerate_triangles)},
          {"keeps_distance", or_null(certificate.keeps_distance)},
          {"message", certificate.message},
          {"first",
           {{"self_intersections", certificate.first_self_intersections},
            {"model_cage_intersections", certificate.first_model_cage_intersections},
            {"vertices_outside", certificate.first_vertices_outside},
            {"degenerate_triangles", certificate.first_degenerate_triangles}}}};
}

Json to_json(const Report::Tightness& tightness) {
  return {{"volume_ratio", or_null(tightness.volume_ratio)},
          {"mean_gap_over_diagonal", or_null(tightness.mean_gap_over_diagonal)},
          {"max_gap_over_diagonal", or_null(tightness.max_gap_over_diagonal)},
          {"clearance_over_diagonal", or_null(tightness.clearance_over_diagonal)},
          {"coverage", or_null(tightness.coverage)}};
}

Json to_json(const Report::Quality& quality) {
  return {{"least_dihedral", or_null(quality.least_dihedral)},
          {"greatest_dihedral", or_null(quality.greatest_dihedral)},
          {"greatest_aspect", or_null(quality.greatest_aspect)},
          {"mean_asymmetry_over_diagonal", or_null(quality.mean_asymmetry_over_diagonal)},
          {"max_asymmetry_over_diagonal", or_null(quality.max_asymmetry_over_diagonal)},
          {"worst_squareness", or_null(quality.worst_squareness)},
          {"worst_planarity_over_diagonal", or_null(quality.worst_planarity_over_diagonal)},
          {"worst_twist", or_null(quality.worst_twist)}};
}

Json to_json(const Report::Timings& timings) {
  return {{"read", or_null(timings.read)},       {"prepare", or_null(timings.prepare)},
          {"segment", or_null(timings.segment)}, {"orient", or_null(timings.orient)},
          {"meshing", or_null(timings.meshing)}, {"refine", or_null(timings.refine)},
          {"enclose", or_null(timings.enclose)}, {"write", or_null(timings.write)},
          {"total", or_null(timings.total)}};
}

Json to_json(const std::vector<std::pair<std::string, Report::Option>>& options) {
  Json json = Json::object();
  for (const auto& option : options) std::visit([&](const auto& x) { json[option.first] = x; }, option.second);
  return json;
}

// What a report says of one cage.
void add_findings(const Report& report, Json& json) {
  json["model"] = to_json(report.model);
  json["slides"] = to_json(report.slides);
  json["parts"] = or_null(report.parts);
  json["cage"] = {{"vertices", or_null(report.cage.vertices)},
                  {"triangles", or_null(report.cage.triangles)},
                  {"genus", or_null(report.cage.genus)}};
  json["refinement"] = to_json(report.refinement);
  json["certificate"] = to_json(report.certificate);
  json["tightness"] = to_json(report.tightness);
  json["quality"] = to_json(report.quality);
}

}  // namespace

std::string report_text(const Report& report) { return reports_text({report}); }

std::string reports_text(const std::vector<Report>& reports) {
  const Report& first = reports.front();
  Json json;
  add_findings(first, json);
  if (reports.size() > 1) {
    Json cages = Json::array();
    for (const Report& report : reports) {
      Json cage = {{"node", report.node}};
      add_findings(report, cage);
      cages.push_back(std::move(cage));
    }
    json["cages"] = std::move(cages);
  }
  json["timings_ms"] = to_json(first.timings_ms);
  json["peak_memory_mb"] = or_null(first.peak_memory_mb);
  json["version"] = first.version;
  json["options"] = to_json(first.options);
  // Paths need not be UTF-8.
  return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

std::string certificate_text(const Report::Certificate& certificate) { return to_json(certificate).dump(); }

}  // namespace cagewright::host
