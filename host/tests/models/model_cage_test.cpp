// SPDX-License-Identifier: BSD-3-Clause
//
// The whole road on whole models: the program, its plug-in, the file it writes.
#include "host/tests/models/model_cage.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iostream>

#include "testdata/oracle/oracle.h"

namespace cagewright::host {
namespace {

using nlohmann::json;

constexpr double threshold = 1e-3;  // of equation (9), over the diagonal

class ModelCage : public testing::TestWithParam<Model> {
 protected:
  void SetUp() override {
    if (const auto why = GetParam().why_missing()) GTEST_SKIP() << *why;
    result = make_cage(folder, GetParam().file(), GetParam().slides_file());
    ASSERT_EQ(result.run.exit_code, 0) << result.run.errors;
  }

  TemporaryFolder folder;
  CageRun result;
};

// |-max signed distance - delta| of the last iteration, over the diagonal.
double equation_9(const json& refinement, double delta) {
  return std::abs(-refinement.at("max_signed_distance_over_diagonal").back().get<double>() - delta);
}

TEST_P(ModelCage, HasTheGenusThatModelAndSlidesImply) {
  const Model& model = GetParam();
  ASSERT_EQ(model.genus, model.slides - model.parts + 1) << "parts joined by sections, in one component";
  const json report = result.report();
  EXPECT_EQ(report["model"]["components"], 1);
  EXPECT_EQ(report["model"]["closed"], true);
  EXPECT_EQ(report["model"]["genus"], model.genus);
  EXPECT_EQ(report["parts"], model.parts);
  EXPECT_EQ(report["cage"]["genus"], model.genus);
}

TEST_P(ModelCage, UsesEverySlideOfTheFile) {
  std::ifstream file(GetParam().slides_file());
  const json slides = json::parse(file).at("slides");
  ASSERT_EQ(slides.size(), static_cast<std::size_t>(GetParam().slides));
  ASSERT_EQ(result.report()["slides"].size(), slides.size());
  for (std::size_t i = 0; i < slides.size(); ++i) {
    EXPECT_EQ(result.report()["slides"][i], json({{"name", slides[i]["name"]}, {"status", "ok"}, {"message", ""}}));
  }
}

// As the paper has it; enclosing asks for the refinement of sections in plane, which is harder.
TEST_P(ModelCage, MeetsEquation9InTimeWhereItIsNotToEnclose) {
  const TemporaryFolder folder_of_paper;
  const CageRun paper =
      make_cage(folder_of_paper, GetParam().file(), GetParam().slides_file(), {"--set", "enclose.mode=off"});
  ASSERT_EQ(paper.run.exit_code, 0) << paper.run.errors;
  const json refinement = paper.report()["refinement"];
  EXPECT_EQ(refinement["converged"], true);
  EXPECT_LE(refinement["iterations"], GetParam().most_iterations);
  EXPECT_EQ(refinement["max_signed_distance_over_diagonal"].size(), refinement["iterations"].get<std::size_t>() + 1);
  EXPECT_LE(equation_9(refinement, 0), threshold);
  EXPECT_TRUE(paper.report()["timings_ms"]["enclose"].is_null());
}

TEST_P(ModelCage, FileIsAClosedOrientedManifold) {
  const SurfaceFacts facts = facts_of(result.cage);
  EXPECT_EQ(result.report()["certificate"]["closed"], true);
  EXPECT_EQ(facts.unpaired_edges, 0u);
  EXPECT_EQ(facts.torn_vertices, 0u);
  EXPECT_EQ(facts.euler, 2 - 2 * GetParam().genus);
  EXPECT_GT(facts.volume, 0);
  EXPECT_EQ(result.report()["cage"]["vertices"], result.cage.vertices.size());
  EXPECT_EQ(result.report()["cage"]["triangles"], result.cage.triangles.size());
}

TEST_P(ModelCage, IsAtMostTwiceAsLargeAsTheModel) {
  const double ratio = facts_of(result.cage).volume / facts_of(read_off(GetParam().file())).volume;
  EXPECT_GT(ratio, 1);
  EXPECT_LE(ratio, 2);
  EXPECT_NEAR(result.report()["tightness"]["volume_ratio"].get<double>() / ratio, 1, 1e-9);
}

TEST_P(ModelCage, IndependentOracleAgrees) {
  if (oracle.empty()) GTEST_SKIP() << no_oracle;
  const json verdict = ask_oracle(oracle, GetParam().file(), folder / "cage.obj");
  EXPECT_EQ(verdict["closed"], true);
  EXPECT_EQ(verdict["euler"], 2 - 2 * GetParam().genus);
  EXPECT_EQ(verdict["cage_vertices"], result.report()["cage"]["vertices"]);
  EXPECT_EQ(verdict["cage_triangles"], result.report()["cage"]["triangles"]);
  EXPECT_EQ(verdict["model_triangles"], result.report()["model"]["triangles"]);
  // It prints six digits.
  EXPECT_NEAR(verdict["volume_ratio"].get<double>() / result.report()["tightness"]["volume_ratio"].get<double>(), 1,
              5e-6);
  const json certificate = result.report()["certificate"];
  EXPECT_EQ(certificate["encloses"], true) << certificate["message"];
  EXPECT_EQ(certificate["keeps_distance"], true);
  EXPECT_EQ(verdict["self_intersecting_pairs"], certificate["self_intersections"]);
  EXPECT_EQ(verdict["model_triangles_crossing_cage"], certificate["model_cage_intersections"]);
  EXPECT_EQ(verdict["model_vertices_outside"], certificate["vertices_outside"]);
  const json tightness = result.report()["tightness"];
  for (const char* gap : {"mean_gap_over_diagonal", "max_gap_over_diagonal"}) {
    EXPECT_NEAR(verdict[gap].get<double>() / tightness[gap].get<double>(), 1, 1e-4) << gap;
  }
}

TEST(Delta, IsTheLeastDistanceOfTheCertifiedCage) {
  const Model& biped = model_named("biped");
  if (const auto why = biped.why_missing()) GTEST_SKIP() << *why;
  const TemporaryFolder folder;
  for (const double delta : {0.001, 0.01}) {
    const CageRun cage = make_cage(folder, biped.file(), biped.slides_file(), {"--delta", std::to_string(delta)});
    ASSERT_EQ(cage.run.exit_code, 0) << cage.run.errors << cage.run.output;
    EXPECT_EQ(cage.report()["certificate"]["keeps_distance"], true);
    EXPECT_GE(cage.report()["tightness"]["clearance_over_diagonal"], delta);
    EXPECT_LE(cage.report()["tightness"]["clearance_over_diagonal"], 1.5 * delta);
  }
}

TEST(Delta, LoosensThePapersCageByASettledShareOfTheDiagonal) {
  const Model& biped = model_named("biped");
  if (const auto why = biped.why_missing()) GTEST_SKIP() << *why;
  const TemporaryFolder folder;
  const std::vector<std::string> off = {"--set", "enclose.mode=off"};
  const CageRun tight = make_cage(folder, biped.file(), biped.slides_file(), off);
  const CageRun loose =
      make_cage(folder, biped.file(), biped.slides_file(), {"--delta", "0.01", "--set", "enclose.mode=off"});
  ASSERT_EQ(tight.run.exit_code + loose.run.exit_code, 0) << tight.run.errors << loose.run.errors;
  EXPECT_EQ(loose.report()["refinement"]["converged"], true);
  EXPECT_LE(loose.report()["refinement"]["iterations"], biped.most_iterations);
  EXPECT_LE(equation_9(loose.report()["refinement"], 0.01), threshold);
  EXPECT_EQ(facts_of(loose.cage).unpaired_edges, 0u);
  EXPECT_GT(facts_of(loose.cage).volume, facts_of(tight.cage).volume);
}

INSTANTIATE_TEST_SUITE_P(Models, ModelCage, testing::ValuesIn(all_models()),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace cagewright::host
