// SPDX-License-Identifier: BSD-3-Clause
//
// The program as other programs see it: exit codes, files, one clear line on stderr.
#include <nlohmann/json.hpp>

#include "host/file/mesh_reader.h"
#include "host/file/mesh_writer.h"
#include "host/tests/program_fixture.h"
#include "host/tests/sample_meshes.h"

namespace cagewright::host {
namespace {

using nlohmann::json;
using Names = std::set<std::string>;

class ProgramTest : public ProgramFixture {};

TEST_F(ProgramTest, MakesACageAndAReport) {
  const ProgramRun run = cage({"-o", at("cage.obj"), "--report", at("r.json"), "--set", "refine.scope=part", "--lambda",
                               "2.5", "--threads", "1"});
  EXPECT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_NE(run.output.find("cage: 8 vertices, 12 triangles, genus 0, closed"), std::string::npos) << run.output;
  EXPECT_EQ(read_mesh(at("cage.obj")).mesh.points[3], 2.1);
  const json report = json::parse(folder.read("r.json"));
  EXPECT_EQ(report["model"]["vertices"], 8);
  EXPECT_EQ(report["slides"][1], json({{"name", "b"}, {"status", "ok"}, {"message", ""}}));
  EXPECT_EQ(report["parts"], 3);
  EXPECT_EQ(report["refinement"]["max_signed_distance_over_diagonal"], json({0.25, 0.125, 0.0005}));
  EXPECT_EQ(report["certificate"]["closed"], true);
  EXPECT_EQ(report["certificate"]["encloses"], true);
  EXPECT_EQ(report["tightness"]["clearance_over_diagonal"], 0.125);
  EXPECT_TRUE(report["tightness"]["coverage"].is_null());
  EXPECT_EQ(report["quality"]["worst_squareness"], 0.0625);
  EXPECT_EQ(report["timings_ms"]["enclose"], 5);
  EXPECT_TRUE(report["timings_ms"]["meshing"].is_null()) << "the plug-in did not compute it";
  EXPECT_EQ(report["timings_ms"]["refine"], 4);
  EXPECT_GT(report["timings_ms"]["total"], 0);
  EXPECT_GT(report["peak_memory_mb"], 1);
  EXPECT_EQ(report["options"]["refine.scope"], "part");
  EXPECT_EQ(report["options"]["orient.lambda"], 2.5);
  EXPECT_EQ(folder.names(), (Names{"m.off", "s.json", "cage.obj", "r.json"}));
}

TEST_F(ProgramTest, WritesTheCageInEveryFormat) {
  for (const std::string name : {"c.obj", "c.off", "c.ply", "c.stl", "c.glb", "c.gltf", "C.OBJ"}) {
    EXPECT_EQ(cage({"-o", at(name)}).exit_code, 0);
    EXPECT_EQ(read_mesh(at(name), MeshRole::cage).mesh.triangle_count(), 12u) << name;
  }
}

TEST_F(ProgramTest, TellsStagesAndNotesOnStderrUnlessQuiet) {
  const ProgramRun run = cage({});
  EXPECT_EQ(run.errors,
            "cagewright: read\ncagewright: a note of two lines\ncagewright: segment\ncagewright: refine\n"
            "cagewright: write\n");
  EXPECT_EQ(cage({"--quiet"}).errors, "");
}

TEST_F(ProgramTest, WritesTheFilesButExitsWith1WhereTheCertificateFails) {
  const ProgramRun run = cage({"-o", at("cage.obj"), "--report", at("r.json")}, "crossing");
  EXPECT_EQ(run.exit_code, 1);
  for (const char* part :
       {"certificate: NONE", "1 pair of cage triangles that meet, the first: triangle 3 and triangle 7",
        "1 model vertex not inside, the first: 5", "move slide 'a'"}) {
    EXPECT_NE(run.output.find(part), std::string::npos) << part << " is not in " << run.output;
  }
  const json certificate = json::parse(folder.read("r.json"))["certificate"];
  EXPECT_EQ(certificate["encloses"], false);
  EXPECT_EQ(certificate["self_intersections"], 1);
  EXPECT_EQ(certificate["first"]["self_intersections"], json({{3, 7}}));
  EXPECT_EQ(certificate["first"]["vertices_outside"], json({5}));
  EXPECT_EQ(certificate["message"], "move slide 'a'");
  EXPECT_TRUE(std::filesystem::exists(at("cage.obj")));
  EXPECT_EQ(cage({}, "too_near").exit_code, 1);
  EXPECT_EQ(cage({}, "crossing,no_enclose").exit_code, 0) << "nobody has asked for a certificate";
}

TEST_F(ProgramTest, WritesTheFilesButExitsWith1WhereTheCageIsOpen) {
  const ProgramRun run = cage({"-o", at("cage.obj"), "--report", at("r.json")}, "open_cage");
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_NE(run.output.find("NOT closed"), std::string::npos);
  EXPECT_EQ(read_mesh(at("cage.obj")).mesh.triangle_count(), 11u);
  EXPECT_EQ(json::parse(folder.read("r.json"))["certificate"]["closed"], false);
  EXPECT_TRUE(json::parse(folder.read("r.json"))["cage"]["genus"].is_null());
}

TEST_F(ProgramTest, HelpAndVersionGoToStdout) {
  EXPECT_EQ(run_program({"--version"}).output.find("cagewright "), 0u);
  for (const auto& arguments : {std::vector<std::string>{"--help"}, {"cage", "--help"}}) {
    const ProgramRun run = run_program(arguments);
    EXPECT_EQ(run.exit_code, 0);
    EXPECT_NE(run.output.find("Usage"), std::string::npos);
  }
}

TEST_F(ProgramTest, ExitsWith3AndNamesTheBadInput) {
  const std::string out = at("cage.obj");
  expect_failure(run_program({"cage", at("none.off"), "-o", out}), 3, {"none.off", "no such file"});
  expect_failure(run_program({"cage", at("s.json"), "-o", out}), 3, {"s.json", "\".json\" is unknown"});
  expect_failure(run_program({"cage", at("m.off"), "--slides", at("no.json"), "-o", out}), 3,
                 {"no.json", "no such file"});
  expect_failure(run_program({"cage", at("m.off"), "--slides", at("m.off"), "-o", out}), 3,
                 {"m.off, line 1", "not JSON"});
  expect_failure(cage({"-o", out}, "mesh_open"), 3, {"m.off", "3 open edges", "vertex 7"});
  expect_failure(cage({"-o", out}, "slides_touch"), 3, {"s.json", "\"a\" and \"b\" touch"});
  expect_failure(cage({"-o", out, "--set", "refine.magic=1"}), 3, {"refine.magic=1", "no parameter"});
  expect_failure(cage({"-o", out, "--lambda", "-1"}), 3, {"--lambda -1", "at least 0"});
  expect_failure(cage({"-o", at("no/cage.obj")}), 3, {"cage.obj", "cannot be written", "no folder"});
  expect_failure(cage({"-o", out, "--report", at("no/r.json")}), 3, {"r.json", "cannot be written", "no folder"});
  expect_failure(cage({"-o", out, "--plugin", at("none.so")}), 3, {"none.so", "no such plug-in"});
  expect_failure(cage({"-o", out, "--plugin", at("m.off")}), 3, {"m.off", "cannot be loaded"});
}

TEST_F(ProgramTest, NamesTheSlideThatThePluginRefuses) {
  folder.write("s.json", R"({"version": 1, "slides": [{"name": "wrist", "stroke": [[0,0,0]]}]})");
  expect_failure(cage({"-o", at("cage.obj")}), 3, {"s.json", "\"wrist\"", "too few points"});
}

TEST_F(ProgramTest, SaysWithoutADisplayThatThereIsNoPicture) {
  expect_failure(cage({"-o", at("cage.obj"), "--picture", at("p.png")}), 3, {"DISPLAY"});
}

TEST_F(ProgramTest, ExitsWith4ForDefectsOfThePlugin) {
  expect_failure(cage({"-o", at("cage.obj")}, "internal"), 4, {"a defect in stage refine"});
  expect_failure(cage({"-o", at("cage.obj")}, "out_of_memory"), 4, {"not enough memory"});
}

TEST_F(ProgramTest, LeavesOldFilesWhereItFails) {
  folder.write("cage.obj", "old");
  folder.write("r.json", "old");
  EXPECT_EQ(cage({"-o", at("cage.obj"), "--report", at("r.json")}, "slides_touch").exit_code, 3);
  EXPECT_EQ(folder.read("cage.obj") + folder.read("r.json"), "oldold");
}

TEST_F(ProgramTest, WritesNothingWhereOneOfTheFilesCannotBeWritten) {
  if (!std::filesystem::is_character_file("/dev/full")) GTEST_SKIP() << "this system has no /dev/full";
  EXPECT_EQ(cage({"--report", "/dev/full"}).exit_code, 3);
  TriangleMesh far = unit_cube();
  for (double& x : far.points) x *= 1e39;
  folder.write("m.off", mesh_bytes(far, "m.off"));
  expect_failure(cage({"-o", at("cage.glb"), "--report", at("r.json")}), 3, {"cage.glb", "vertex", "floats"});
}

TEST_F(ProgramTest, WritesNothingWhereItsSummaryCannotBeWritten) {
  if (!std::filesystem::is_character_file("/dev/full")) GTEST_SKIP() << "this system has no /dev/full";
  const auto run = [](const std::vector<std::string>& arguments) {
    std::vector<std::string> all = {"-c", "exec \"$0\" \"$@\" > /dev/full", PROGRAM};
    all.insert(all.end(), arguments.begin(), arguments.end());
    return run_program(all, {}, "/bin/sh");
  };
  const std::vector<std::string> parts = {"standard output cannot be written", "No space left"};
  expect_failure(run({"cage", at("m.off"), "-o", at("cage.obj"), "--report", at("r.json")}), 3, parts);
  expect_failure(run({"check", at("m.off"), at("m.off"), "--report", at("r.json")}), 3, parts);
  expect_failure(run({"params"}), 3, parts);
  expect_failure(run({"--help"}), 3, parts);
}

TEST_F(ProgramTest, WritesNothingWhereNobodyReadsItsSummary) {
  Program program({"cage", at("m.off"), "-o", at("cage.obj"), "--quiet"}, {{"CAGEWRIGHT_FAKE", "slow"}});
  program.close_output();
  expect_failure(program.finish(), 3, {"standard output cannot be written", "Broken pipe"});
}

TEST_F(ProgramTest, CageWithoutSlidesIsABoxAndSaysSo) {
  const ProgramRun run = run_program({"cage", at("m.off")});
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_NE(run.errors.find("no slides are given"), std::string::npos);
}

TEST_F(ProgramTest, CheckTellsModelAndCageApart) {
  folder.write("cage.obj", mesh_bytes(unit_cube(), "cage.obj"));
  const ProgramRun run = run_program({"check", at("m.off"), at("cage.obj"), "--report", at("r.json")});
  EXPECT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_NE(run.output.find("volume ratio: 1.5"), std::string::npos) << run.output;
  EXPECT_NE(run.output.find("certificate: the cage encloses the model"), std::string::npos) << run.output;
  const json report = json::parse(folder.read("r.json"));
  EXPECT_EQ(report["certificate"]["closed"], true);
  EXPECT_EQ(report["cage"], json({{"vertices", 8}, {"triangles", 12}, {"genus", 0}}));
}

TEST_F(ProgramTest, CheckExitsWith1ForACageThatIsOpenOrInconsistent) {
  TriangleMesh open = unit_cube(), turned = unit_cube();
  open.triangles.resize(33);
  std::swap(turned.triangles[0], turned.triangles[1]);
  folder.write("open.obj", mesh_bytes(open, "a.obj"));
  folder.write("turned.obj", mesh_bytes(turned, "a.obj"));
  const ProgramRun first = run_program({"check", at("m.off"), at("open.obj")}, {{"CAGEWRIGHT_FAKE", "open_cage"}});
  EXPECT_EQ(first.exit_code, 1);
  EXPECT_NE(first.output.find("3 open edges"), std::string::npos) << first.output;
  EXPECT_NE(first.output.find("certificate: NONE"), std::string::npos) << first.output;
  const ProgramRun second = run_program({"check", at("m.off"), at("turned.obj")}, {{"CAGEWRIGHT_FAKE", "open_cage"}});
  EXPECT_EQ(second.exit_code, 1);
  EXPECT_NE(second.output.find("3 inconsistently oriented edges"), std::string::npos) << second.output;
}

TEST_F(ProgramTest, CheckExitsWith3ForBadInput) {
  expect_failure(run_program({"check", at("m.off"), at("none.obj")}), 3, {"none.obj", "no such file"});
}

TEST_F(ProgramTest, FindsThePluginBesideItselfAndInTheLibraryFolder) {
  const std::string program = at("prefix/bin/cagewright");
  std::filesystem::create_directories(at("prefix/bin"));
  std::filesystem::create_directories(at("prefix/lib/cagewright"));
  std::filesystem::copy_file(PROGRAM, program);
  const auto params = [&] { return run_program({"params"}, {{"CAGEWRIGHT_PLUGIN", ""}}, program); };
  for (const std::string place : {"prefix/bin", "prefix/lib/cagewright"}) {
    const std::string plugin = at(place + "/cagewright_plugin.so");
    std::filesystem::copy_file(FAKE_PLUGIN, plugin);
    const ProgramRun run = params();
    EXPECT_EQ(run.exit_code, 0) << place << ": " << run.errors;
    EXPECT_NE(run.output.find("Weight of alignment."), std::string::npos) << place;
    std::filesystem::remove(plugin);
  }
}

TEST_F(ProgramTest, ParamsListsThePluginsParameters) {
  const ProgramRun table = run_program({"params"});
  EXPECT_EQ(table.exit_code, 0);
  for (const char* part : {"orient.lambda", "0 to inf", "local, part", "Weight of alignment."}) {
    EXPECT_NE(table.output.find(part), std::string::npos) << table.output;
  }
  const json list = json::parse(run_program({"params", "--json"}).output);
  ASSERT_EQ(list.size(), 3u);
  EXPECT_EQ(list[2]["id"], "refine.scope");
  EXPECT_EQ(list[2]["default"], "local");
  EXPECT_EQ(list[2]["choices"], json({"local", "part"}));
  EXPECT_TRUE(list[0]["maximum"].is_null());
}

TEST_F(ProgramTest, ValidateRefusesFiguresThatDoNotFitTogether) {
  const ProgramRun run = run_program({"validate", at("m.off"), "--slides", at("s.json"), "--seconds", "0"});
  expect_failure(run, 4, {"internal error: the plug-in hands out ", "its figures cannot be checked"});
}

}  // namespace
}  // namespace cagewright::host
