// SPDX-License-Identifier: BSD-3-Clause
//
// The program saves a scene over itself: whatever goes wrong, the file is the old one or the whole new one.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <random>
#include <thread>

#include "host/scene/scene_document.h"
#include "host/tests/glb_sample.h"
#include "host/tests/run_program.h"
#include "host/tests/sample_meshes.h"
#include "host/tests/scene/folder_watch.h"
#include "host/tests/temporary_folder.h"

namespace cagewright::host::test {
namespace {

using Names = std::set<std::string>;
using Clock = std::chrono::steady_clock;

// A cube, and a picture of `noise` random numbers that only the file's size is about.
std::string scene_bytes(std::size_t noise) {
  const TriangleMesh cube = unit_cube();
  GlbSample sample;
  const std::vector<float> positions(cube.points.begin(), cube.points.end());
  const std::vector<std::uint16_t> indices(cube.triangles.begin(), cube.triangles.end());
  const int position_accessor = sample.accessor(sample.view(positions), gl_float, 8, "VEC3");
  sample.node(sample.mesh(position_accessor, sample.accessor(sample.view(indices), gl_ushort, 36, "SCALAR")));
  std::mt19937 random(1);
  std::vector<std::uint32_t> numbers(noise);
  for (std::uint32_t& number : numbers) number = static_cast<std::uint32_t>(random());
  sample.json["images"] = {{{"bufferView", sample.view(numbers)}, {"mimeType", "image/png"}}};
  return sample.bytes();
}

class Saving : public testing::Test {
 protected:
  std::string at(const std::string& name) const { return (folder / name).string(); }
  std::vector<std::string> cage() const { return {"cage", at("s.glb"), "-o", at("s.glb"), "--quiet"}; }
  std::vector<std::string> strip() const { return {"strip", at("s.glb"), "-o", at("s.glb"), "--quiet"}; }

  // The run failed with one sentence that holds all parts, and the folder is as it was.
  void expect_untouched(const ProgramRun& run, const std::vector<std::string>& parts) const {
    EXPECT_EQ(run.exit_code, 3) << run.errors;
    EXPECT_EQ(std::count(run.errors.begin(), run.errors.end(), '\n'), 1) << run.errors;
    for (const std::string& part : parts) EXPECT_NE(run.errors.find(part), std::string::npos) << run.errors;
    EXPECT_EQ(folder.names(), Names{"s.glb"});
    EXPECT_TRUE(folder.read("s.glb") == before);
  }

  TemporaryFolder folder;
  const std::string before = scene_bytes(20'000);
};

TEST_F(Saving, TakesThePlaceOfTheSceneThatWasRead) {
  folder.write("s.glb", before);
  const ProgramRun run = run_program(cage());
  EXPECT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_EQ(folder.names(), Names{"s.glb"});
  const std::string with_cage = folder.read("s.glb");
  EXPECT_NE(SceneDocument(at("s.glb")).find_cage(0), nullptr);
  EXPECT_EQ(run_program(cage()).exit_code, 0);
  EXPECT_TRUE(folder.read("s.glb") == with_cage) << "another cage takes the place of the first";
  EXPECT_EQ(run_program(strip()).exit_code, 0);
  EXPECT_TRUE(folder.read("s.glb") == before);
  EXPECT_EQ(folder.names(), Names{"s.glb"});
}

TEST_F(Saving, GoesThroughLinksAndOtherSpellings) {
  folder.write("s.glb", before);
  std::filesystem::create_symlink("s.glb", folder / "link.glb");
  EXPECT_EQ(run_program({"cage", at("s.glb"), "-o", at("link.glb")}).exit_code, 0);
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "link.glb"));
  EXPECT_NE(SceneDocument(at("s.glb")).find_cage(0), nullptr);
  EXPECT_EQ(run_program({"strip", at("link.glb"), "-o", at("./s.glb")}).exit_code, 0);
  EXPECT_TRUE(folder.read("s.glb") == before);
  EXPECT_EQ(folder.names(), (Names{"link.glb", "s.glb"}));
}

TEST_F(Saving, KeepsTheOldFileWhereItsFolderIsReadOnly) {
  using std::filesystem::perms;
  const char* const as_user = "/usr/bin/setpriv";
  const bool is_root = ::geteuid() == 0;  // whom no permissions stop
  if (is_root && !std::filesystem::exists(as_user)) GTEST_SKIP() << "setpriv is not there to run it as another user";
  folder.write("s.glb", before);
  const TemporaryFolder tools;
  std::filesystem::copy_file(PROGRAM, tools / "cagewright");
  std::filesystem::copy_file(FAKE_PLUGIN, tools / "plugin.so");
  const perms readable = perms::owner_read | perms::owner_exec | perms::others_read | perms::others_exec;
  for (const auto& path : {tools / ".", folder / "."}) std::filesystem::permissions(path, readable);
  for (std::vector<std::string> arguments : {cage(), strip()}) {
    std::string program = (tools / "cagewright").string();
    if (is_root) {
      arguments.insert(arguments.begin(), {"--reuid=65534", "--regid=65534", "--clear-groups", program});
      program = as_user;
    }
    const ProgramRun run = run_program(arguments, {{"CAGEWRIGHT_PLUGIN", (tools / "plugin.so").string()}}, program);
    expect_untouched(run, {"s.glb", "cannot be written", "Permission denied"});
  }
  for (const auto& path : {tools / ".", folder / "."}) std::filesystem::permissions(path, perms::owner_all);
}

TEST_F(Saving, KeepsTheOldFileWhereFilesMayNotBecomeThatLarge) {
  folder.write("s.glb", before);
  for (const std::vector<std::string>& arguments : {cage(), strip()}) {
    std::vector<std::string> command = {"-c", "ulimit -f 100; exec \"$0\" \"$@\"", PROGRAM};  // of 512 or 1024 bytes
    command.insert(command.end(), arguments.begin(), arguments.end());
    if (arguments.front() == "strip") folder.write("s.glb", before);
    const ProgramRun run = run_program(command, {}, "/bin/sh");
    expect_untouched(run, {"s.glb", "cannot be written", "File too large"});
  }
}

// With a file system of its own that holds the file once, not twice.
TEST_F(Saving, KeepsTheOldFileWhereTheDiskIsFull) {
  std::filesystem::create_directory(folder / "disk");
  folder.write("s.glb", before);
  const auto in_namespace = [&](const std::string& script) {
    const char* options = ::geteuid() == 0 ? "-m" : "-rm";
    return run_program({"unshare", options, "sh", "-c", script, at("disk"), at("s.glb"), PROGRAM}, {}, "/usr/bin/env");
  };
  const std::string mount = "mount -t tmpfs -o size=128k none \"$0\" || exit 77; ";
  if (in_namespace(mount).exit_code != 0) GTEST_SKIP() << "nothing can be mounted here";
  for (const std::string command : {"cage", "strip"}) {
    const ProgramRun run = in_namespace(mount + "cp \"$1\" \"$0\"; cd \"$0\"; \"$2\" " + command +
                                        " s.glb -o s.glb --quiet; code=$?; ls -A; cmp s.glb \"$1\" && exit $code");
    EXPECT_EQ(run.exit_code, 3) << run.output << run.errors;
    EXPECT_EQ(run.output, "s.glb\n") << "a temporary file is left";
    EXPECT_EQ(run.errors, "cagewright: s.glb: cannot be written: No space left on device\n");
  }
}

TEST_F(Saving, WritesNoneOfItsFilesWhereOneIsTooLarge) {
  folder.write("s.glb", before);
  std::vector<std::string> command = {"-c", "ulimit -f 100; exec \"$0\" \"$@\"", PROGRAM};
  for (const std::string& argument : cage()) command.push_back(argument);
  command.insert(command.end(), {"--report", at("r.json")});
  expect_untouched(run_program(command, {}, "/bin/sh"), {"s.glb", "File too large"});
}

// Where a kill has found the program.
struct Moments {
  int before = 0, during = 0, after = 0;
};

// Lets the program save s.glb again and again and kills it.
class Killing : public Saving {
 protected:
  using Seconds = std::chrono::duration<double>;
  struct Times {
    Seconds whole{}, save{};  // from its start to its end; from the first byte that is written to the new name
  };

  Killing() {
    folder.write("s.glb", without);
    EXPECT_EQ(run_program(cage()).exit_code, 0);
    with = folder.read("s.glb");
    EXPECT_NE(SceneDocument(at("s.glb")).find_cage(0), nullptr);
    EXPECT_FALSE(with == without);
  }

  bool has_cage() const { return folder.read("s.glb") == with; }
  // The command that changes the file.
  std::vector<std::string> next() const { return has_cage() ? strip() : cage(); }
  bool has_leftovers() const { return folder.names().size() > 1; }

  // The median of some runs.
  Times measure() {
    std::vector<Seconds> whole, save;
    for (int run = 0; run < 7 && !HasFailure(); ++run) {
      FolderWatch watch(folder / ".");
      const auto start = Clock::now();
      Program program(next());
      EXPECT_TRUE(watch.wait_for_creation());
      const auto first_byte = Clock::now();
      EXPECT_TRUE(watch.wait_for_renaming());
      save.push_back(Clock::now() - first_byte);
      EXPECT_EQ(program.finish().exit_code, 0);
      whole.push_back(Clock::now() - start);
    }
    for (std::vector<Seconds>* times : {&whole, &save}) std::sort(times->begin(), times->end());
    return {whole[whole.size() / 2], save[save.size() / 2]};
  }

  // Kills the program `delay` after its start, or after the first byte that it writes.
  void kill_once(bool is_saving, Seconds delay) {
    const bool had_cage = has_cage();
    FolderWatch watch(folder / ".");
    Program program(next());
    ASSERT_TRUE(!is_saving || watch.wait_for_creation());
    std::this_thread::sleep_for(delay);
    program.send(SIGKILL);
    program.finish();
    const std::string left = folder.read("s.glb");
    ASSERT_TRUE(left == with || left == without) << "damaged: " << left.size() << " bytes";
    if (left == (had_cage ? without : with)) {
      ++moments.after;
    } else {
      ++(has_leftovers() ? moments.during : moments.before);
    }
    clear_leftovers();
  }

  void clear_leftovers() const {
    for (const std::string& name : folder.names()) {
      if (name != "s.glb") std::filesystem::remove(folder / name);
    }
  }

  const std::string without = scene_bytes(500'000);
  std::string with;
  Moments moments;
};

TEST_F(Killing, LeavesTheOldFileOrTheWholeNewOne) {
  const Times times = measure();
  if (HasFailure()) return;
  std::mt19937 random(1);
  const auto part = [&] { return static_cast<double>(random()) / static_cast<double>(std::mt19937::max()); };
  for (int kill = 0; kill < 200; ++kill) {
    SCOPED_TRACE("kill " + std::to_string(kill));
    const bool is_saving = kill % 2 == 0;
    kill_once(is_saving, part() * 1.2 * (is_saving ? times.save : times.whole));
    if (HasFailure()) return;
  }
  RecordProperty("before", moments.before);
  RecordProperty("during", moments.during);
  RecordProperty("after", moments.after);
  EXPECT_GT(moments.before, 5);
  EXPECT_GT(moments.during, 5) << "the kills have missed the save";
  EXPECT_GT(moments.after, 5);
}

TEST_F(Killing, LeavesNothingThatDisturbsTheNextSave) {
  for (int tries = 0; tries < 50 && folder.names().size() < 4; ++tries) {
    FolderWatch watch(folder / ".");
    Program program(next());
    ASSERT_TRUE(watch.wait_for_creation());
    program.send(SIGKILL);
    program.finish();
  }
  const Names left = folder.names();
  ASSERT_GE(left.size(), 2u) << "no kill has come in time";
  const std::string expected = has_cage() ? without : with;
  EXPECT_EQ(run_program(next()).exit_code, 0);
  EXPECT_TRUE(folder.read("s.glb") == expected);
  EXPECT_EQ(folder.names(), left);
}

}  // namespace
}  // namespace cagewright::host::test
