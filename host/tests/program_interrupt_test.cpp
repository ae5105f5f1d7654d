// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <thread>

#include "host/file/mesh_writer.h"
#include "host/tests/run_program.h"
#include "host/tests/sample_meshes.h"
#include "host/tests/temporary_folder.h"

namespace cagewright::host {
namespace {

class ProgramInterruptTest : public testing::Test {
 protected:
  ProgramInterruptTest() { folder.write("m.off", mesh_bytes(unit_cube(), "m.off")); }

  Program start(const std::string& fake) const {
    return Program({"cage", (folder / "m.off").string(), "-o", (folder / "cage.obj").string()},
                   {{"CAGEWRIGHT_FAKE", fake}});
  }

  TemporaryFolder folder;
};

TEST_F(ProgramInterruptTest, CancelsTheSolveAndWritesNothing) {
  Program program = start("wait");
  program.wait_for_error_text("refine");
  program.send(SIGINT);
  const ProgramRun run = program.finish();
  EXPECT_EQ(run.exit_code, 130);
  EXPECT_TRUE(run.errors.ends_with("cagewright: cancelled; nothing was written\n")) << run.errors;
  EXPECT_EQ(folder.names(), (std::set<std::string>{"m.off"}));
}

TEST_F(ProgramInterruptTest, WritesNothingWhereThePluginWentOnToTheEnd) {
  Program program = start("slow");
  program.wait_for_error_text("refine");
  program.send(SIGINT);
  EXPECT_EQ(program.finish().exit_code, 130);
  EXPECT_EQ(folder.names(), (std::set<std::string>{"m.off"}));
}

TEST_F(ProgramInterruptTest, TheSecondOneEndsTheProgramAtOnce) {
  Program program = start("deaf");
  program.wait_for_error_text("refine");
  program.send(SIGINT);
  std::this_thread::sleep_for(std::chrono::milliseconds(100));  // two signals at once may be taken for one
  program.send(SIGINT);
  EXPECT_EQ(program.finish().exit_code, 128 + SIGINT);
}

}  // namespace
}  // namespace cagewright::host
