// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

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

  void expect_cancelled(Program& program) const {
    const ProgramRun run = program.finish();
    EXPECT_EQ(run.exit_code, 130);
    EXPECT_EQ(run.output, "");
    EXPECT_TRUE(run.errors.ends_with("cagewright: cancelled; nothing was written\n")) << run.errors;
  }

  TemporaryFolder folder;
};

// An X server that takes connections and never answers.
class SilentDisplay {
 public:
  SilentDisplay() {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof(address);
    socket_ = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    EXPECT_EQ(::bind(socket_, reinterpret_cast<const sockaddr*>(&address), size), 0);
    EXPECT_EQ(::listen(socket_, 1), 0);
    EXPECT_EQ(::getsockname(socket_, reinterpret_cast<sockaddr*>(&address), &size), 0);
    port_ = ntohs(address.sin_port);
  }
  ~SilentDisplay() {
    ::close(client_);
    ::close(socket_);
  }
  SilentDisplay(const SilentDisplay&) = delete;
  SilentDisplay& operator=(const SilentDisplay&) = delete;

  // Display n of a host is its port 6000 + n.
  std::string name() const { return "127.0.0.1:" + std::to_string(port_ - 6000); }
  void wait_for_client() {
    pollfd waiting = {socket_, POLLIN, 0};
    ASSERT_EQ(::poll(&waiting, 1, 20'000), 1) << "nobody came to display " << name();
    client_ = ::accept4(socket_, nullptr, nullptr, SOCK_CLOEXEC);
  }

 private:
  int socket_ = -1, client_ = -1, port_ = 0;
};

TEST_F(ProgramInterruptTest, CancelsTheSolveAndWritesNothing) {
  for (const int signal : {SIGINT, SIGTERM}) {
    Program program = start("wait");
    program.wait_for_error_text("refine");
    program.send(signal);
    expect_cancelled(program);
    EXPECT_EQ(folder.names(), (std::set<std::string>{"m.off"}));
  }
}

TEST_F(ProgramInterruptTest, WritesNothingWhereThePluginWentOnToTheEnd) {
  Program program = start("slow");
  program.wait_for_error_text("refine");
  program.send(SIGINT);
  EXPECT_EQ(program.finish().exit_code, 130);
  EXPECT_EQ(folder.names(), (std::set<std::string>{"m.off"}));
}

TEST_F(ProgramInterruptTest, EndsAtOnceWhileThePluginTakesTheModelIn) {
  for (const int signal : {SIGINT, SIGTERM}) {
    Program program = start("mesh_log,mesh_deaf");
    program.wait_for_error_text("mesh\n");
    program.send(signal);
    expect_cancelled(program);
    EXPECT_EQ(folder.names(), (std::set<std::string>{"m.off"}));
  }
}

TEST_F(ProgramInterruptTest, EndsAtOnceWhileItReadsALargeFile) {
  // Large enough that the signal comes long before the last line, which would be an error.
  std::string text;
  for (int i = 0; i < 4'000'000; ++i) text += "v 0.25 0.5 1\n";
  folder.write("large.obj", text + "f 1 2 x\n");
  Program program({"cage", (folder / "large.obj").string(), "-o", (folder / "cage.obj").string()});
  program.wait_for_error_text("read");
  program.send(SIGINT);
  expect_cancelled(program);
  EXPECT_EQ(folder.names(), (std::set<std::string>{"large.obj", "m.off"}));
}

TEST_F(ProgramInterruptTest, EndsAtOnceWhileItWaitsForTheDisplay) {
  SilentDisplay display;
  Program program({"cage", (folder / "m.off").string(), "--picture", (folder / "p.png").string()},
                  {{"DISPLAY", display.name()}});
  display.wait_for_client();
  program.send(SIGINT);
  expect_cancelled(program);
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
