// SPDX-License-Identifier: BSD-3-Clause
//
// A fault in the plug-in is found, and the sentence names the stage.
#include <gtest/gtest.h>

#include <filesystem>
#include <ostream>

#include "host/tests/run_program.h"

namespace cagewright::host {
namespace {

struct Fault {
  const char* name;
  std::vector<std::string> sentence;  // parts of the one that is expected
  std::vector<std::string> settings;
};

void PrintTo(const Fault& fault, std::ostream* out) { *out << fault.name; }

class PlantedFault : public testing::TestWithParam<Fault> {};

TEST_P(PlantedFault, IsFoundAndItsStageNamed) {
  if (std::string(CAGEWRIGHT_OWN_MODELS).empty()) {
    GTEST_SKIP() << "biped is not made: configure with -DCAGEWRIGHT_BUILD_TESTDATA=ON";
  }
  const Fault& fault = GetParam();
  const std::filesystem::path models = CAGEWRIGHT_OWN_MODELS, slides = CAGEWRIGHT_SLIDE_FILES, faults = FAULTS;
  std::vector<std::string> arguments = {"validate",  models / "biped.off",
                                        "--slides",  slides / "biped.slides.json",
                                        "--plugin",  faults / (std::string(fault.name) + ".so"),
                                        "--starts",  "5",
                                        "--seconds", "0",
                                        "--quiet"};
  for (const std::string& setting : fault.settings) arguments.insert(arguments.end(), {"--set", setting});
  const ProgramRun run = run_program(arguments);
  EXPECT_EQ(run.exit_code, 1) << run.errors;
  EXPECT_NE(run.output.find("the plug-in's figures DO NOT hold\n"), run.output.npos) << run.output;
  for (const std::string& part : fault.sentence) EXPECT_NE(run.output.find(part), run.output.npos) << run.output;
}

INSTANTIATE_TEST_SUITE_P(
    Faults, PlantedFault,
    testing::Values(
        Fault{"weights_not_squared", {"  refine: iteration ", "the weight of equation (8) is "}, {}},
        Fault{"vertex_off", {"  refine: iteration ", ", vertex 17 of the cage: equation (8) gives (", "apart\n"}, {}},
        Fault{"damping_doubled", {"  refine: iteration ", "its damping "}, {}},
        Fault{"anchors_inward",
              {"  refine: iteration ", "(7) gives the anchor ("},
              {"enclose.mode=off", "refine.delta=0.01"}},
        Fault{"outermost_missed", {"  refine: iteration ", "farther out than the one of (6)"}, {}},
        Fault{"normals_stretched", {"  refine: iteration ", "its corners have the normal ("}, {}},
        Fault{"step_lost", {"  refine: iteration 1", "but the iteration before left it at ("}, {}},
        Fault{"plane_ignored", {"  refine: iteration 0", "it is to move across ("}, {}},
        Fault{"transport_cubed", {"  orient: the section of slide '", "the least of equation (1) is at x = ("}, {}},
        Fault{"weights_of_sizes", {"  orient: the section of slide '", "the least of equation (1) is at x = ("}, {}},
        Fault{"rectangle_of_radius", {"  orient: the section of slide '", "the ellipse reaches "}, {}},
        Fault{"cage_shrunk", {"  enclose: the cage is called enclosing, but winds "}, {}}),
    [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace cagewright::host
