// SPDX-License-Identifier: BSD-3-Clause
#include "host/file/report_file.h"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <set>

namespace cagewright::host {
namespace {

using nlohmann::json;

std::set<std::string> keys(const json& object) {
  std::set<std::string> result;
  for (const auto& [key, value] : object.items()) result.insert(key);
  return result;
}

TEST(ReportFile, HasExactlyTheDocumentedKeys) {
  Report report;
  report.slides.push_back({"wrist", "ok", ""});
  const json j = json::parse(report_text(report));
  EXPECT_EQ(keys(j),
            (std::set<std::string>{"model", "slides", "parts", "cage", "refinement", "certificate", "tightness",
                                   "quality", "timings_ms", "peak_memory_mb", "version", "options"}));
  EXPECT_EQ(keys(j["model"]), (std::set<std::string>{"vertices", "triangles", "components", "genus", "closed"}));
  EXPECT_EQ(keys(j["slides"][0]), (std::set<std::string>{"name", "status", "message"}));
  EXPECT_EQ(keys(j["cage"]), (std::set<std::string>{"vertices", "triangles", "genus"}));
  EXPECT_EQ(keys(j["refinement"]),
            (std::set<std::string>{"iterations", "converged", "max_signed_distance_over_diagonal"}));
  EXPECT_EQ(keys(j["certificate"]),
            (std::set<std::string>{"closed", "self_intersections", "model_cage_intersections", "vertices_outside",
                                   "encloses", "degenerate_triangles", "keeps_distance", "message", "first"}));
  EXPECT_EQ(keys(j["tightness"]),
            (std::set<std::string>{"volume_ratio", "mean_gap_over_diagonal", "max_gap_over_diagonal",
                                   "clearance_over_diagonal", "coverage"}));
  EXPECT_EQ(keys(j["quality"]),
            (std::set<std::string>{"least_dihedral", "greatest_dihedral", "greatest_aspect",
                                   "mean_asymmetry_over_diagonal", "max_asymmetry_over_diagonal", "worst_squareness",
                                   "worst_planarity_over_diagonal", "worst_twist"}));
  EXPECT_EQ(keys(j["timings_ms"]), (std::set<std::string>{"read", "prepare", "segment", "orient", "meshing", "refine",
                                                          "enclose", "write", "total"}));
}

TEST(ReportFile, WritesNullForWhatNobodyComputed) {
  const json j = json::parse(report_text({}));
  for (const char* object : {"model", "cage", "certificate", "tightness", "quality", "timings_ms"}) {
    for (const auto& [key, value] : j[object].items()) {
      if (key == "first" || key == "message") continue;
      EXPECT_TRUE(value.is_null()) << object << "." << key;
    }
  }
  EXPECT_TRUE(j["parts"].is_null());
  EXPECT_TRUE(j["refinement"]["converged"].is_null());
  EXPECT_TRUE(j["peak_memory_mb"].is_null());
}

TEST(ReportFile, WritesNullForNumbersThatAreNotFinite) {
  Report report;
  report.tightness.volume_ratio = std::numeric_limits<double>::infinity();
  report.refinement.max_signed_distance_over_diagonal = {std::nullopt, std::numeric_limits<double>::quiet_NaN(), 0.5};
  const json j = json::parse(report_text(report));
  EXPECT_TRUE(j["tightness"]["volume_ratio"].is_null());
  EXPECT_EQ(j["refinement"]["max_signed_distance_over_diagonal"], json({nullptr, nullptr, 0.5}));
}

TEST(ReportFile, KeepsOptionsWithTheirTypes) {
  Report report;
  report.options = {{"a", true}, {"b", std::int64_t{7}}, {"c", 0.1}, {"d", std::string("local")}};
  EXPECT_EQ(json::parse(report_text(report))["options"], json({{"a", true}, {"b", 7}, {"c", 0.1}, {"d", "local"}}));
}

TEST(ReportFile, SurvivesPathsThatAreNotUtf8) {
  Report report;
  report.options = {{"model", std::string("\xFF.obj")}};
  EXPECT_NO_THROW(json::parse(report_text(report)));
}

}  // namespace
}  // namespace cagewright::host
