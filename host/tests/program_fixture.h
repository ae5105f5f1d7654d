// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_TESTS_PROGRAM_FIXTURE_H
#define CAGEWRIGHT_HOST_TESTS_PROGRAM_FIXTURE_H

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

#include "host/file/mesh_writer.h"
#include "host/tests/run_program.h"
#include "host/tests/sample_meshes.h"
#include "host/tests/temporary_folder.h"

namespace cagewright::host {

// A folder with the model m.off and two slides in s.json.
class ProgramFixture : public testing::Test {
 protected:
  ProgramFixture() {
    TriangleMesh model = unit_cube();
    for (double& x : model.points) x = 2 * x + 0.1;
    folder.write("m.off", mesh_bytes(model, "m.off"));
    folder.write("s.json", R"({"version": 1, "slides": [{"name": "a", "point": [0,0,0], "normal": [0,0,1]},
                                                        {"name": "b", "center": [0,0,0], "u": [1,0,0], "v": [0,1,0]}]})");
  }

  std::string at(const std::string& name) const { return (folder / name).string(); }

  // `cage` on the model and the slides with more arguments.
  ProgramRun cage(std::vector<std::string> arguments, const std::string& fake = "") const {
    arguments.insert(arguments.begin(), {"cage", at("m.off"), "--slides", at("s.json")});
    return run_program(arguments, {{"CAGEWRIGHT_FAKE", fake}});
  }

  // The run failed with this code, said so in one last line that holds all parts, and left no file behind.
  void expect_failure(const ProgramRun& run, int exit_code, const std::vector<std::string>& parts) const {
    EXPECT_EQ(run.exit_code, exit_code) << run.errors;
    EXPECT_EQ(run.output, "");
    ASSERT_TRUE(run.errors.ends_with('\n')) << run.errors;
    const std::size_t begin = run.errors.rfind('\n', run.errors.size() - 2) + 1;  // npos + 1 is 0
    const std::string line = run.errors.substr(begin);
    EXPECT_EQ(line.find("cagewright: "), 0u) << run.errors;
    for (const std::string& part : parts) EXPECT_NE(line.find(part), line.npos) << part << "\nis not in: " << line;
    EXPECT_EQ(folder.names(), (std::set<std::string>{"m.off", "s.json"}));
  }

  TemporaryFolder folder;
};

}  // namespace cagewright::host

#endif
