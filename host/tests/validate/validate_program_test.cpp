// SPDX-License-Identifier: BSD-3-Clause
//
// `cagewright validate` with the true plug-in.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "host/tests/run_program.h"
#include "host/tests/temporary_folder.h"

namespace cagewright::host {
namespace {

using nlohmann::json;

class ValidateProgram : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    const std::string name = GetParam();
    is_own_ = name == "biped" || name == "genus3";
    const std::string folder_of_models = is_own_ ? CAGEWRIGHT_OWN_MODELS : CAGEWRIGHT_REAL_MODELS;
    if (folder_of_models.empty()) {
      GTEST_SKIP() << name
                   << (is_own_ ? " is not made: configure with -DCAGEWRIGHT_BUILD_TESTDATA=ON"
                               : " is a real model: configure with -DCAGEWRIGHT_REAL_MODELS=DIR");
    }
    model_ = (std::filesystem::path(folder_of_models) / (name + ".off")).string();
    slides_ = (std::filesystem::path(CAGEWRIGHT_SLIDE_FILES) / (name + ".slides.json")).string();
  }

  ProgramRun validate(std::vector<std::string> more) const {
    more.insert(more.begin(), {"validate", model_, "--slides", slides_});
    return run_program(more);
  }

  bool is_own_ = true;
  std::string model_, slides_;
  TemporaryFolder folder;
};

TEST_P(ValidateProgram, AgreesWithThePlugIn) {
  const ProgramRun run = validate({"--report", (folder / "r.json").string(), "--seconds", "0"});
  ASSERT_EQ(run.exit_code, 0) << run.output << run.errors;
  EXPECT_TRUE(run.output.ends_with("the plug-in's figures hold\n")) << run.output;
  const json report = json::parse(folder.read("r.json"));
  EXPECT_EQ(report["agrees"], true);
  const json cage = report["cages"][0];
  EXPECT_GT(cage["iterations"], 0);
  std::set<std::string> stages;
  for (const json& check : cage["checks"]) {
    EXPECT_EQ(check["holds"], true) << check["fault"];
    EXPECT_LE(check["worst"].get<double>(), check["tolerance"].get<double>());
    EXPECT_GT(check["comparisons"], 0) << check["claim"];
    stages.insert(check["stage"]);
  }
  EXPECT_EQ(stages, (std::set<std::string>{"segment", "orient", "refine", "enclose"}));
  EXPECT_EQ(cage["equation_1"]["starts"], 200);
  EXPECT_LE(cage["equation_1"]["linear_percent_above_best"].get<double>(), 5);
  EXPECT_TRUE(cage["optimality"].is_null());
}

class ValidateOwnModel : public ValidateProgram {};

// A wide distance, for which limbs would be merged.
TEST_P(ValidateOwnModel, AgreesWhereLimbsAreInEachOthersWayAndOverAngles) {
  const ProgramRun run = validate({"--set", "refine.delta=0.05", "--set", "orient.minimum=angles", "--starts", "5",
                                   "--seconds", "0", "--report", folder / "r.json"});
  EXPECT_EQ(run.exit_code, 0) << run.output << run.errors;
  const json equation = json::parse(folder.read("r.json"))["cages"][0]["equation_1"];
  EXPECT_LE(equation["sections_percent_above_best"].get<double>(), 1e-4);
}

TEST_P(ValidateOwnModel, AgreesWithThePapersRuleForOutermostVerticesAndADistance) {
  const ProgramRun run = validate({"--set", "enclose.mode=off", "--set", "refine.scope=part", "--set",
                                   "refine.delta=0.01", "--starts", "5", "--seconds", "0"});
  EXPECT_EQ(run.exit_code, 0) << run.output << run.errors;
}

INSTANTIATE_TEST_SUITE_P(Models, ValidateProgram,
                         testing::Values("biped", "genus3", "armadillo", "elk", "man", "bunny00", "elephant"),
                         [](const auto& test) { return std::string(test.param); });

INSTANTIATE_TEST_SUITE_P(Models, ValidateOwnModel, testing::Values("biped", "genus3"),
                         [](const auto& test) { return std::string(test.param); });

class ValidateBiped : public ValidateProgram {};

TEST_P(ValidateBiped, MakesATighterCertifiedCageAndSaysByHowMuch) {
  const ProgramRun run = validate({"--report", (folder / "r.json").string(), "--seconds", "6", "--starts", "5"});
  ASSERT_EQ(run.exit_code, 0) << run.output << run.errors;
  const json cage = json::parse(folder.read("r.json"))["cages"][0];
  for (const char* kind : {"shaped", "free"}) {
    const json tighter = cage["optimality"][kind];
    EXPECT_GT(tighter["certified_rounds"], 0) << kind;
    EXPECT_GT(tighter["volume_ratio"], 1) << kind;
    EXPECT_LT(tighter["volume_ratio"], cage["volume_ratio"]) << kind;
    EXPECT_NEAR(tighter["gap_percent"].get<double>(),
                100 * (cage["volume_ratio"].get<double>() / tighter["volume_ratio"].get<double>() - 1), 1e-6);
  }
  EXPECT_NE(run.output.find("optimality gap, sections free: "), run.output.npos) << run.output;
}

TEST_P(ValidateBiped, TakesASceneAndNamesItsNodes) {
  const std::string scene = (folder / "scene.glb").string();
  ASSERT_EQ(run_program({"cage", model_, "--slides", slides_, "-o", scene, "--quiet"}).exit_code, 0);
  const ProgramRun run = run_program({"validate", scene, "--starts", "5", "--seconds", "0", "--quiet"});
  EXPECT_EQ(run.exit_code, 0) << run.output << run.errors;
  EXPECT_EQ(run.errors, "");
}

TEST_P(ValidateBiped, PageSaysWhyItHasNoPicturesWithoutADisplay) {
  const ProgramRun run = validate({"--html", (folder / "p.html").string(), "--starts", "5", "--seconds", "0"});
  ASSERT_EQ(run.exit_code, 0) << run.output << run.errors;
  const std::string page = folder.read("p.html");
  EXPECT_NE(page.find("There are no pictures: "), page.npos);
  EXPECT_NE(page.find("DISPLAY"), page.npos);
  EXPECT_EQ(page.find("<img"), page.npos);
}

TEST_P(ValidateBiped, SaysWhatIsWrongWithItsInput) {
  EXPECT_EQ(validate({"--html", model_}).exit_code, 2);
  EXPECT_EQ(validate({"--seconds", "-1"}).exit_code, 2);
  EXPECT_EQ(validate({"--set", "orient.lambda=-2"}).exit_code, 3);
  const ProgramRun run = run_program({"validate", (folder / "none.glb").string()});
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_NE(run.errors.find("none.glb"), run.errors.npos) << run.errors;
}

INSTANTIATE_TEST_SUITE_P(Models, ValidateBiped, testing::Values("biped"));

}  // namespace
}  // namespace cagewright::host
