// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <nlohmann/json.hpp>

#include "host/validate/validation_file.h"

namespace cagewright::host {
namespace {

using Json = nlohmann::ordered_json;

Json to_json(const Check& check) {
  return {{"stage", check.stage},         {"claim", check.claim}, {"holds", check.holds()},     {"worst", check.worst},
          {"tolerance", check.tolerance}, {"unit", check.unit},   {"comparisons", check.count}, {"fault", check.fault}};
}

Json to_json(const OrientationFigures& o) {
  return {{"linear", o.linear},
          {"sections", o.plugin},
          {"nearest_minimum", o.from_plugin},
          {"best", o.best},
          {"starts", o.starts},
          {"starts_that_reach_best", o.reached},
          {"linear_percent_above_best", 100 * o.linear_off},
          {"sections_percent_above_best", 100 * o.plugin_off}};
}

Json to_json(const TighterCage& tighter) {
  return {{"volume_ratio", tighter.volume_ratio},  {"gap_percent", 100 * tighter.gap}, {"rounds", tighter.rounds},
          {"certified_rounds", tighter.certified}, {"settled", tighter.settled},       {"seconds", tighter.seconds}};
}

Json to_json(const Validation& v) {
  Json json;
  json["node"] = v.node;
  json["agrees"] = v.agrees();
  json["model_triangles"] = v.model_triangles;
  json["slides"] = v.slides;
  json["cage_triangles"] = v.cage_triangles;
  json["iterations"] = v.iterations;
  json["certified"] = v.certified;
  json["volume_ratio"] = v.volume_ratio;
  json["max_signed_distance_over_diagonal"] = v.max_signed_distances;
  json["checks"] = Json::array();
  for (const Check& check : v.checks) json["checks"].push_back(to_json(check));
  json["equation_1"] = to_json(v.orientation);
  json["optimality"] = nullptr;
  if (v.optimality)
    json["optimality"] = {{"shaped", to_json(v.optimality->shaped)}, {"free", to_json(v.optimality->free)}};
  return json;
}

}  // namespace

bool ValidationReport::agrees() const {
  return std::all_of(cages.begin(), cages.end(), [](const Validation& cage) { return cage.agrees(); });
}

std::string validation_json(const ValidationReport& report) {
  Json json;
  json["agrees"] = report.agrees();
  json["model"] = report.model;
  json["cages"] = Json::array();
  for (const Validation& cage : report.cages) json["cages"].push_back(to_json(cage));
  json["version"] = report.version;
  json["options"] = Json::object();
  for (const auto& [name, value] : report.options) json["options"][name] = value;
  return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

}  // namespace cagewright::host
