// SPDX-License-Identifier: BSD-3-Clause
//
// What the program says of a command line that makes no sense.
#include "host/tests/program_fixture.h"

namespace cagewright::host {
namespace {

class ProgramUsageTest : public ProgramFixture {
 protected:
  void expect_refusal(const std::vector<std::string>& arguments, const std::string& part) const {
    const ProgramRun run = run_program(arguments);
    SCOPED_TRACE(run.errors);
    expect_failure(run, 2, {part});
    EXPECT_TRUE(run.errors.ends_with("; see --help\n"));
    EXPECT_EQ(run.errors.find('\n'), run.errors.size() - 1) << "more than one line";
  }
  void expect_cage_refusal(std::vector<std::string> options, const std::string& part) const {
    options.insert(options.begin(), {"cage", at("m.off")});
    expect_refusal(options, part);
  }
};

TEST_F(ProgramUsageTest, NamesTheArgumentThatIsMissing) {
  expect_refusal({}, "subcommand");
  expect_refusal({"cage"}, "MODEL");
  expect_refusal({"check", at("m.off")}, "CAGE");
  expect_cage_refusal({"-o"}, "--out");
}

TEST_F(ProgramUsageTest, NamesTheArgumentThatItDoesNotKnow) {
  expect_refusal({"bake"}, "bake");
  expect_refusal({"-x"}, "argument was not expected: -x");
  expect_refusal({"cage", "--colour"}, "argument was not expected: --colour");
  expect_cage_refusal({"--colour"}, "argument was not expected: --colour");
  expect_cage_refusal({"more.off"}, "argument was not expected: more.off");
  expect_refusal({"view", "--theme", "blue"}, "--theme");
  expect_refusal({"validate", "scene.glb", "--all"}, "argument was not expected: --all");
}

TEST_F(ProgramUsageTest, NamesTheOptionWhoseValueItCannotRead) {
  expect_cage_refusal({"--delta", "much"}, "--delta: needs a number, not \"much\"");
  expect_cage_refusal({"--lambda", "4x"}, "--lambda: needs a number");
  expect_cage_refusal({"--iterations", ""}, "--iterations: needs a number");
  expect_cage_refusal({"--set", "refine.scope"}, "--set: needs ID=VALUE, not \"refine.scope\"");
  expect_cage_refusal({"--set", "two\nlines"}, "two?lines");
  expect_cage_refusal({"--threads", "-1"}, "--threads");
}

TEST_F(ProgramUsageTest, RefusesOutputsThatItCannotMakeBeforeItWorks) {
  expect_cage_refusal({"-o", at("cage.fbx")}, "cage.fbx");
  for (const std::string name : {"p.jpg", "p", "p.png.txt"}) {
    expect_cage_refusal({"--picture", at(name)}, at(name) + ": a picture is written as .png");
  }
  expect_cage_refusal({"-o", at("m.off")}, "m.off is named twice");
  expect_cage_refusal({"-o", at("a.obj"), "--report", at("./a.obj")}, "a.obj is named twice");
  expect_refusal({"check", at("m.off"), at("c.off"), "--report", at("m.off")}, "m.off is named twice");
}

TEST_F(ProgramUsageTest, RefusesDirectionsThatMakeNoView) {
  const auto expect = [&](std::vector<std::string> options, const std::string& part) {
    options.insert(options.begin(), {"--picture", at("p.png")});
    expect_cage_refusal(options, part);
  };
  expect({"--picture-up", "0,1"}, "--picture-up: needs three numbers X,Y,Z");
  expect({"--picture-up", "0,1,0,0"}, "\"0,1,0,0\"");
  expect({"--picture-from", "a,b,c"}, "--picture-from: needs three numbers X,Y,Z");
  expect({"--picture-from", "1,nan,0"}, "--picture-from 1,nan,0: its numbers have to be finite");
  expect({"--picture-up", "inf,0,0"}, "--picture-up inf,0,0: its numbers have to be finite");
  expect({"--picture-up", "0,-0,0"}, "--picture-up 0,-0,0: gives no direction");
  expect({"--picture-up", "0,0,2", "--picture-from", "0,0,-1"}, "--picture-from 0,0,-1: is parallel");
  expect({"--picture-from", "0,3,0"}, "0,1,0 without a --picture-up");
}

TEST_F(ProgramUsageTest, RefusesSizesOfPictureThatCannotBeMade) {
  const auto expect = [&](const std::string& size, const std::string& part) {
    expect_cage_refusal({"--picture", at("p.png"), "--picture-size", size}, part);
  };
  expect("800", "needs two whole numbers WxH");
  expect("800x600x2", "\"800x600x2\"");
  expect("8.5x600", "\"8.5x600\"");
  expect("15x600", "--picture-size 15x600: either has to be from 16 to 4096");
  expect("600x4097", "from 16 to 4096");
  expect_cage_refusal({"--picture-size", "80x60"}, "--picture-size requires --picture");
}

TEST_F(ProgramUsageTest, NamesTheShortFormThatWasTypedWhereItsValueIsOutOfRange) {
  for (const std::string option : {"--lambda", "--iterations"}) {
    const ProgramRun run = cage({"-o", at("cage.obj"), option, "-2"});
    expect_failure(run, 3, {"cagewright: " + option + " -2: "});
    EXPECT_EQ(run.errors.find("--set"), std::string::npos) << run.errors;
  }
  expect_failure(cage({"--delta", "2"}), 3, {"cagewright: --delta 2: "});
  expect_failure(cage({"--set", "orient.lambda=-2"}), 3, {"cagewright: --set orient.lambda=-2: "});
}

}  // namespace
}  // namespace cagewright::host
