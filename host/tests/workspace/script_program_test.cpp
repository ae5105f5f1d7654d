// SPDX-License-Identifier: BSD-3-Clause
//
// `cagewright --command FILE` as a program of its own.
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <thread>

#include "host/file/mesh_writer.h"
#include "host/tests/run_program.h"
#include "host/tests/temporary_folder.h"
#include "host/tests/workspace/ellipsoid.h"
#include "host/workspace/script.h"

namespace cagewright::host::test {
namespace {

using Json = nlohmann::json;

class ScriptProgramTest : public testing::Test {
 protected:
  ScriptProgramTest() { folder_.write("limb.off", mesh_bytes(ellipsoid(24, 48), "limb.off")); }

  std::string at(const std::string& name) const { return (folder_ / name).string(); }
  // Lines with FOLDER, SCENES and PLUGIN in their paths.
  std::string script(const std::string& name, std::string lines) const {
    for (const auto& [word, path] : {std::pair<std::string, std::string>{"FOLDER", at("")},
                                     {"SCENES", CAGEWRIGHT_OWN_SCENES},
                                     {"\"PLUGIN\"", "\"" CAGEWRIGHT_PLUGIN_FILE "\""}}) {
      for (std::size_t k = 0; (k = lines.find(word, k)) != std::string::npos; k += path.size()) {
        lines.replace(k, word.size(), path);
      }
    }
    return folder_.write(name, lines).string();
  }
  static ProgramRun run(const std::vector<std::string>& arguments) {
    return run_program(arguments, {{"CAGEWRIGHT_PLUGIN", CAGEWRIGHT_PLUGIN_FILE}});
  }
  void expect_stop(const std::string& lines, const std::string& place, const std::string& part) const {
    const ProgramRun stopped = run({"--command", script("s.script", lines)});
    SCOPED_TRACE(stopped.errors);
    EXPECT_EQ(stopped.exit_code, 3);
    EXPECT_TRUE(stopped.errors.starts_with("cagewright: " + at("s.script") + place));
    EXPECT_NE(stopped.errors.find(part), std::string::npos);
    EXPECT_EQ(stopped.errors.find('\n'), stopped.errors.size() - 1) << "more than one line";
  }

  TemporaryFolder folder_;
};

constexpr char good_script[] =
    "# a limb\n"
    "\n"
    "{\"command\": \"open\", \"path\": \"FOLDER/limb.off\"}\r\n"
    "   # its slides\n"
    "{\"command\": \"add_slide\", \"point\": [0.3, 0.5, 0], \"normal\": [0, 1, 0]}\n"
    "{\"command\": \"save\", \"path\": \"FOLDER/limb.glb\"}\n"
    "{\"command\": \"report\"}";

TEST_F(ScriptProgramTest, RunsEachLineAndSaysWhatCommandsSay) {
  const ProgramRun done = run({"--command", script("s.script", good_script)});
  EXPECT_EQ(done.exit_code, 0) << done.errors;
  EXPECT_EQ(done.errors, "");
  std::istringstream lines(done.output);
  std::string slide, report, more;
  std::getline(lines, slide);
  std::getline(lines, report);
  EXPECT_FALSE(std::getline(lines, more)) << more;
  EXPECT_EQ(Json::parse(slide), Json::parse(R"({"slide": "slide 1"})"));
  EXPECT_EQ(Json::parse(report)["certificate"]["encloses"], true);
  EXPECT_FALSE(folder_.read("limb.glb").empty());
}

TEST_F(ScriptProgramTest, TheSameScriptWritesTheSameBytes) {
  const std::string path = script("s.script", good_script);
  run({"--command", path});
  const std::string first = folder_.read("limb.glb");
  EXPECT_EQ(run({"--command", path}).exit_code, 0);
  EXPECT_EQ(folder_.read("limb.glb"), first);
}

TEST_F(ScriptProgramTest, EveryCommandRunsInOneSessionTwiceToTheSameBytes) {
  std::ifstream file(CAGEWRIGHT_EVERY_COMMAND);
  const std::string session{std::istreambuf_iterator<char>(file), {}};
  std::set<std::string> used = {"picture", "turntable"}, there;  // these need a display
  std::istringstream lines(session);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("{")) used.insert(Json::parse(line)["command"].get<std::string>());
  }
  for (const ScriptRunner::Description& command : ScriptRunner::commands()) there.insert(command.name);
  EXPECT_EQ(used, there) << "every_command.jsonl has to use them all";
  std::map<std::string, std::string> written;
  for (const bool is_first : {true, false}) {
    const ProgramRun done = run({"--command", script("every_command.jsonl", session)});
    EXPECT_EQ(done.exit_code, 0) << done.errors;
    EXPECT_EQ(done.errors, "");
    for (const char* name : {"limb.glb", "cage.obj", "two.json", "two.glb"}) {
      const std::string bytes = folder_.read(name);
      EXPECT_FALSE(bytes.empty()) << name;
      if (is_first) written[name] = bytes;
      EXPECT_TRUE(written[name] == bytes) << name;
    }
  }
}

TEST_F(ScriptProgramTest, StopsAtTheFirstCommandThatFailsAndNamesItsLine) {
  const std::string open = "{\"command\": \"open\", \"path\": \"FOLDER/limb.off\"}\n";
  expect_stop("\n# nothing\n{\"command\": \"fly\"}\n", ":3: ", "no command \"fly\"");
  expect_stop("{\"command\"", ":1: ", "is not JSON");
  expect_stop("{\"command\": \"close\", \"command\": \"close\"}", ":1: ", "twice");
  expect_stop("{\"command\": \"open\", \"path\": \"FOLDER/none.off\"}", ":1: ", "none.off");
  expect_stop(open + "{\"command\": \"undo\"}", ":2: ", "nothing to undo");
  expect_stop(open + "{\"command\": \"add_slide\", \"name\": \"far\", \"point\": [0, 9, 0], \"normal\": [0, 1, 0]}",
              ":2: ", "'far'");
  expect_stop(open + "{\"command\": \"picture\", \"path\": \"FOLDER/p.png\"}", ":2: ", "display");
  expect_stop("{\"command\": \"load_plugin\", \"path\": \"FOLDER/limb.off\"}", ":1: ", "limb.off");
  expect_stop("{\"command\": \"save\"}\n" + open, ":1: ", "no scene is open");
  EXPECT_EQ(folder_.names(), (std::set<std::string>{"limb.off", "s.script"}));
}

TEST_F(ScriptProgramTest, ACageWithoutACertificateIsExitCodeOne) {
  const std::string lines =
      "{\"command\": \"open\", \"path\": \"FOLDER/limb.off\"}\n"
      "{\"command\": \"add_slide\", \"name\": \"a\", \"center\": [0, 9, 0], \"u\": [1, 0, 0], \"v\": [0, 0, 1]}\n"
      "{\"command\": \"wait\"}\n";
  const ProgramRun failed = run({"--command", script("s.script", lines)});
  EXPECT_EQ(failed.exit_code, 1) << failed.errors;
  EXPECT_NE(failed.errors.find("s.script:3: slide 'a' "), std::string::npos) << failed.errors;
  EXPECT_NE(failed.output.find("'a'"), std::string::npos) << "the problem is said";
  const ProgramRun mended =
      run({"--command", script("s.script", lines + "{\"command\": \"undo\"}\n{\"command\": \"wait\"}")});
  EXPECT_EQ(mended.exit_code, 0) << mended.output;
}

TEST_F(ScriptProgramTest, ACageWhoseSolveWasCancelledIsExitCodeOneAndIsNotToldAsOneThatDoesNotEnclose) {
  std::string lines = "{\"command\": \"open\", \"path\": \"FOLDER/limb.off\"}\n";
  for (const char* y : {"-0.4", "0", "0.4"})
    lines += std::string("{\"command\": \"add_slide\", \"point\": [0, ") + y + ", 0], \"normal\": [0, 1, 0]}\n";
  const ProgramRun cancelled =
      run({"--command", script("s.script", lines + "{\"command\": \"cancel\"}\n{\"command\": \"wait\"}\n")});
  EXPECT_EQ(cancelled.exit_code, 1);
  EXPECT_NE(cancelled.errors.find("s.script:6: no cage was made of the slides as they are"), std::string::npos)
      << cancelled.errors;
}

TEST_F(ScriptProgramTest, WhatMakesNoSenseOnTheCommandLineIsExitCodeTwo) {
  const std::string path = script("s.script", "");
  EXPECT_EQ(run({"--command", path}).exit_code, 0) << "an empty script is one";
  EXPECT_EQ(run({"--command"}).exit_code, 2);
  EXPECT_EQ(run({"--command", path, "params"}).exit_code, 2);
  EXPECT_EQ(run({"--plugin", "x.so"}).exit_code, 2);
  const ProgramRun none = run({"--command", at("none.script")});
  EXPECT_EQ(none.exit_code, 3);
  EXPECT_NE(none.errors.find("none.script"), std::string::npos);
  EXPECT_EQ(run({"--command", at("")}).exit_code, 3);
  EXPECT_EQ(run({"--command", path, "--plugin", at("limb.off")}).exit_code, 3);
}

TEST_F(ScriptProgramTest, CtrlCEndsAScriptThatWaitsForACage) {
  folder_.write("big.off", mesh_bytes(ellipsoid(300, 300), "big.off"));
  std::string lines = "{\"command\": \"open\", \"path\": \"FOLDER/big.off\"}\n";
  for (const char* y : {"-1.5", "-1", "-0.5", "0", "0.5", "1", "1.5"}) {
    lines += std::string("{\"command\": \"add_slide\", \"point\": [0.2, ") + y + ", 0], \"normal\": [0, 1, 0]}\n";
  }
  lines += "{\"command\": \"export_cage\", \"path\": \"FOLDER/first.obj\"}\n";
  for (int again = 0; again < 100; ++again) lines += "{\"command\": \"solve\"}\n{\"command\": \"wait\"}\n";
  lines += "{\"command\": \"save\", \"path\": \"FOLDER/big.glb\"}\n";
  Program program({"--command", script("s.script", lines)}, {{"CAGEWRIGHT_PLUGIN", CAGEWRIGHT_PLUGIN_FILE}});
  while (folder_.names().count("first.obj") == 0) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  program.send(SIGINT);
  const auto begin = std::chrono::steady_clock::now();
  const ProgramRun ended = program.finish();
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(3));
  EXPECT_EQ(ended.exit_code, 130) << ended.errors;
  EXPECT_NE(ended.errors.find("cancelled; what was written before stays"), std::string::npos) << ended.errors;
  EXPECT_EQ(folder_.names(), (std::set<std::string>{"big.off", "first.obj", "limb.off", "s.script"}));
}

}  // namespace
}  // namespace cagewright::host::test
