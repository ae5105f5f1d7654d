// SPDX-License-Identifier: BSD-3-Clause
#include "host/file/atomic_file.h"

#include <sys/stat.h>
#include <unistd.h>

#include "host/tests/expect_file_error.h"
#include "host/tests/temporary_folder.h"

namespace cagewright::host {
namespace {

TEST(AtomicFile, LeavesNothingWithoutCommit) {
  const TemporaryFolder folder;
  folder.write("a.txt", "old");
  {
    const AtomicFile file(folder / "a.txt", "new");
    EXPECT_EQ(folder.read("a.txt"), "old");
    EXPECT_EQ(folder.names().size(), 2u);
  }
  EXPECT_EQ(folder.read("a.txt"), "old");
  EXPECT_EQ(folder.names(), (std::set<std::string>{"a.txt"}));
}

TEST(AtomicFile, ReplacesTheFileAtCommit) {
  const TemporaryFolder folder;
  folder.write("a.txt", "old and longer");
  AtomicFile file(folder / "a.txt", "new");
  file.commit();
  EXPECT_EQ(folder.read("a.txt"), "new");
  EXPECT_EQ(folder.names(), (std::set<std::string>{"a.txt"}));
}

TEST(AtomicFile, KeepsPermissionsAndGivesNewFilesTheUsualOnes) {
  const TemporaryFolder folder;
  using std::filesystem::perms;
  const auto mode = [&](const std::string& name) { return std::filesystem::status(folder / name).permissions(); };
  std::filesystem::permissions(folder.write("kept.txt", ""), perms::owner_all);
  const mode_t mask = ::umask(022);
  write_atomically(folder / "kept.txt", "x");
  write_atomically(folder / "new.txt", "x");
  ::umask(mask);
  EXPECT_EQ(mode("kept.txt"), perms::owner_all);
  EXPECT_EQ(mode("new.txt"), perms(0644));
}

TEST(AtomicFile, WritesThroughLinks) {
  const TemporaryFolder folder;
  folder.write("real.txt", "old");
  std::filesystem::create_symlink("real.txt", folder / "link.txt");
  write_atomically(folder / "link.txt", "new");
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "link.txt"));
  EXPECT_EQ(folder.read("real.txt"), "new");
}

TEST(AtomicFile, WritesToDevicesWithoutReplacingThem) {
  write_atomically("/dev/null", "text");
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
}

TEST(AtomicFile, NamesTheFileThatCannotBeWritten) {
  const TemporaryFolder folder;
  const auto expect = [](const std::filesystem::path& path, const std::vector<std::string>& parts) {
    expect_file_error([&] { require_writable(path); }, parts);
    expect_file_error([&] { write_atomically(path, "x"); }, parts);
  };
  expect(folder / "missing/a.txt", {"a.txt", "cannot be written", "no folder", "missing"});
  std::filesystem::create_directory(folder / "folder");
  expect(folder / "folder", {"folder", "cannot be written", "it is a folder"});
  if (std::filesystem::is_character_file("/dev/full")) {
    expect_file_error([] { write_atomically("/dev/full", "x"); }, {"/dev/full", "cannot be written"});
  }
  EXPECT_EQ(folder.names(), (std::set<std::string>{"folder"}));
}

}  // namespace
}  // namespace cagewright::host
