// SPDX-License-Identifier: BSD-3-Clause
//
// Models and cages of others, as they are: open, pinched, inside out.
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "host/tests/models/model_cage.h"
#include "testdata/oracle/oracle.h"

namespace cagewright::host {
namespace {

using nlohmann::json;

const std::filesystem::path real_models = CAGEWRIGHT_REAL_MODELS;
const std::filesystem::path mvc_cages = CAGEWRIGHT_MVC_CAGES;

class OpenModel : public testing::TestWithParam<const char*> {};

TEST_P(OpenModel, IsRefusedWithTheNumberOfItsOpenEdges) {
  if (real_models.empty()) GTEST_SKIP() << "a real model: configure with -DCAGEWRIGHT_REAL_MODELS=DIR";
  const std::filesystem::path file = real_models / (std::string(GetParam()) + ".off");
  const std::size_t open_edges = facts_of(welded(read_off(file))).unpaired_edges;
  ASSERT_GT(open_edges, 0u);
  const TemporaryFolder folder;
  const ProgramRun run = run_program({"cage", file.string(), "-o", (folder / "cage.obj").string(), "--report",
                                      (folder / "report.json").string(), "--quiet"});
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_EQ(run.output, "");
  EXPECT_EQ(run.errors.find("cagewright: " + file.string() + ": "), 0u) << run.errors;
  const std::string count = std::to_string(open_edges) + " open edges";
  EXPECT_NE(run.errors.find("the model is open: " + count), std::string::npos) << run.errors;
  EXPECT_EQ(run.errors.find('\n'), run.errors.size() - 1) << "one line: " << run.errors;
  EXPECT_TRUE(folder.names().empty());
}

INSTANTIATE_TEST_SUITE_P(Real, OpenModel, testing::Values("pig", "lion", "holes", "mannequin-devil"),
                         [](const auto& test) {
                           std::string name = test.param;
                           std::ranges::replace(name, '-', '_');
                           return name;
                         });

TEST(PinchedModel, IsSplitAtItsBowTies) {
  if (real_models.empty()) GTEST_SKIP() << "diplodocus is a real model: configure with -DCAGEWRIGHT_REAL_MODELS=DIR";
  const std::filesystem::path file = real_models / "diplodocus.off";
  ASSERT_EQ(facts_of(read_off(file)).unpaired_edges, 0u);
  ASSERT_GT(facts_of(welded(read_off(file))).torn_vertices, 0u);
  const TemporaryFolder folder;
  folder.write("none.json", R"({"version": 1, "slides": []})");
  const CageRun result = make_cage(folder, file, folder / "none.json");
  ASSERT_EQ(result.run.exit_code, 0) << result.run.errors;
  EXPECT_NE(result.run.errors.find("2 vertices join several fans"), std::string::npos) << result.run.errors;
  EXPECT_EQ(result.report()["model"]["closed"], true);
  EXPECT_EQ(facts_of(result.cage).unpaired_edges, 0u);
  EXPECT_EQ(facts_of(result.cage).torn_vertices, 0u);
  EXPECT_EQ(facts_of(result.cage).euler, 2);
}

class HandMadeCage : public testing::Test {
 protected:
  void SetUp() override {
    if (mvc_cages.empty()) GTEST_SKIP() << "a cage made by hand: configure with -DCAGEWRIGHT_MVC_CAGES=DIR";
  }

  // Output and report of `check` on these files of the folder.
  void check(const std::string& model, const std::string& cage) {
    const TemporaryFolder folder;
    run = run_program({"check", (mvc_cages / model).string(), (mvc_cages / cage).string(), "--report",
                       (folder / "report.json").string()});
    ASSERT_EQ(run.exit_code, 0) << run.errors;
    report = json::parse(folder.read("report.json"));
    EXPECT_EQ(report["certificate"]["closed"], true);
    EXPECT_NE(run.output.find("certificate: the cage encloses the model"), std::string::npos) << run.output;
    EXPECT_EQ(report["certificate"]["encloses"], true);
  }

  // The figures that our slides and at most as many triangles have to reach: ratio and mean gap over the diagonal.
  struct Figures {
    std::string model, slides;
    int most_triangles;
    double ratio, mean_gap;
  };
  static void expect_certified(const Figures& asked) {
    const TemporaryFolder folder;
    const std::filesystem::path model = mvc_cages / asked.model;
    const CageRun result = make_cage(folder, model, std::filesystem::path(CAGEWRIGHT_SLIDE_FILES) / asked.slides);
    ASSERT_EQ(result.run.exit_code, 0) << result.run.errors << result.run.output;
    const json report = result.report();
    EXPECT_EQ(report["certificate"]["encloses"], true);
    EXPECT_LE(report["cage"]["triangles"], asked.most_triangles);
    EXPECT_LE(report["tightness"]["volume_ratio"], asked.ratio);
    EXPECT_LE(report["tightness"]["mean_gap_over_diagonal"], asked.mean_gap);
    EXPECT_LE(report["quality"]["worst_squareness"], 15.01 * std::numbers::pi / 180);
    EXPECT_LE(report["quality"]["worst_planarity_over_diagonal"], 1e-6) << "rounded to floats";
    if (oracle.empty()) return;
    const json verdict = ask_oracle(oracle, model, folder / "cage.obj");
    for (const char* count : {"self_intersecting_pairs", "model_triangles_crossing_cage", "model_vertices_outside"}) {
      EXPECT_EQ(verdict[count], 0) << count;
    }
  }

  ProgramRun run;
  json report;
};

TEST_F(HandMadeCage, OfTheArmadilloIsClosed) {
  check("armadillo/armadilloman.obj", "armadillo/bounding_mesh.obj");
  EXPECT_EQ(run.output.find("inside out"), std::string::npos) << run.output;
  EXPECT_EQ(report["cage"]["triangles"], 216);
  EXPECT_NEAR(report["tightness"]["volume_ratio"], 2.04, 0.005);
  EXPECT_NEAR(report["tightness"]["mean_gap_over_diagonal"], 0.0251, 0.0001);
  EXPECT_NEAR(report["tightness"]["max_gap_over_diagonal"], 0.097, 0.0005);
}

TEST_F(HandMadeCage, OfTheArmadilloIsNotAsTightAsOurs) {
  expect_certified({"armadillo/armadilloman.obj", "armadilloman.slides.json", 216, 1.5, 0.014});
}

TEST_F(HandMadeCage, OfTheHorseIsNotAsTightAsOurs) {
  expect_certified({"horse/horse.obj", "horse.slides.json", 98, 1.9, 0.024});
}

TEST_F(HandMadeCage, OfTheHorseIsJudgedThoughTheHorseIsInsideOut) {
  check("horse/horse.obj", "horse/bounding_meshb.obj");
  EXPECT_NE(run.output.find("inside out"), std::string::npos) << run.output;
  EXPECT_EQ(run.output.find("inside out"), run.output.rfind("inside out")) << "of the model alone: " << run.output;
  EXPECT_EQ(report["cage"]["triangles"], 98);
  EXPECT_NEAR(report["tightness"]["volume_ratio"], 2.40, 0.005);
  EXPECT_NEAR(report["tightness"]["mean_gap_over_diagonal"], 0.0333, 0.0001);
  EXPECT_NEAR(report["tightness"]["max_gap_over_diagonal"], 0.093, 0.0005);
}

TEST_F(HandMadeCage, ModelThatIsInsideOutIsTurnedAndSaidToBe) {
  const TemporaryFolder folder;
  folder.write("none.json", R"({"version": 1, "slides": []})");
  const CageRun result = make_cage(folder, mvc_cages / "horse/horse.obj", folder / "none.json");
  ASSERT_EQ(result.run.exit_code, 0) << result.run.errors;
  EXPECT_NE(result.run.errors.find("inside out"), std::string::npos) << result.run.errors;
  EXPECT_GT(result.report()["tightness"]["volume_ratio"], 1);
  EXPECT_GT(facts_of(result.cage).volume, 0);
}

}  // namespace
}  // namespace cagewright::host
