// SPDX-License-Identifier: BSD-3-Clause
#include "host/file/mesh_reader.h"

#include <sys/stat.h>
#include <unistd.h>

#include "host/file/file_bytes.h"
#include "host/tests/expect_file_error.h"
#include "host/tests/temporary_folder.h"

namespace cagewright::host {
namespace {

const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

TEST(MeshReader, ChoosesTheFormatByTheEndingInAnyCase) {
  const TemporaryFolder folder;
  EXPECT_EQ(read_mesh(folder.write("a.OBJ", triangle)).mesh.triangle_count(), 1u);
  EXPECT_EQ(read_mesh(folder.write("a.Off", "OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")).mesh.triangle_count(), 1u);
}

TEST(MeshReader, ReadsFilesThatAreNamedWithSpacesAndUmlauts) {
  const TemporaryFolder folder;
  EXPECT_EQ(read_mesh(folder.write("ein Bär.obj", triangle)).mesh.triangle_count(), 1u);
}

TEST(MeshReader, NamesTheFileThatCannotBeRead) {
  const TemporaryFolder folder;
  const auto expect = [](const std::filesystem::path& path, const std::vector<std::string>& parts) {
    expect_file_error([&] { read_mesh(path); }, parts);
  };
  expect(folder / "missing.obj", {"missing.obj", "no such file"});
  std::filesystem::create_directory(folder / "folder.obj");
  expect(folder / "folder.obj", {"folder.obj", "is a folder"});
  ASSERT_EQ(::mkfifo((folder / "pipe.obj").c_str(), 0600), 0);
  expect(folder / "pipe.obj", {"pipe.obj", "pipe"});
  expect(folder.write("a.txt", triangle), {"a.txt", "\".txt\"", ".obj"});
  expect(folder.write("model", triangle), {"model", "no ending"});
  expect(folder.write("empty.stl", ""), {"empty.stl", "empty"});
  const std::filesystem::path locked = folder.write("locked.obj", triangle);
  std::filesystem::permissions(locked, std::filesystem::perms::none);
  if (::access(locked.c_str(), R_OK) != 0) expect(locked, {"locked.obj", "cannot be read"});  // root may read all
}

}  // namespace
}  // namespace cagewright::host
