// SPDX-License-Identifier: BSD-3-Clause
#include "host/app/put_aside.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <string>
#include <system_error>

namespace cagewright::host {
namespace fs = std::filesystem;
namespace {

fs::path name_aside(const fs::path& scene, int number) {
  return scene.parent_path() / (scene.stem().string() + "_recovered_" + std::to_string(number) + ".glb");
}

// Where no file can have two names (FAT): the name is taken by an empty file, which nobody else has.
int rename_over_own(const fs::path& from, const fs::path& to) {
  const int file = ::open(to.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
  if (file < 0) return errno;
  ::close(file);
  if (::rename(from.c_str(), to.c_str()) == 0) return 0;
  const int error = errno;
  ::unlink(to.c_str());
  return error;
}

// Of a name that nothing has: else EEXIST. 0: it is done.
int rename_to_free(const fs::path& from, const fs::path& to) {
  if (::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE) == 0) return 0;
  if (errno != EINVAL && errno != ENOSYS) return errno;
  // NFS does not know that; a second name is not given twice either.
  if (::link(from.c_str(), to.c_str()) != 0)
    return errno == EPERM || errno == ENOTSUP || errno == EMLINK ? rename_over_own(from, to) : errno;
  if (::unlink(from.c_str()) == 0) return 0;
  const int error = errno;
  ::unlink(to.c_str());
  return error;
}

}  // namespace

fs::path free_name_aside(const fs::path& scene) {
  int number = 1;
  std::error_code none;
  while (fs::exists(fs::symlink_status(name_aside(scene, number), none))) ++number;
  return name_aside(scene, number);
}

fs::path put_aside(const fs::path& file, const fs::path& scene) {
  for (int number = 1;; ++number) {
    fs::path kept = name_aside(scene, number);
    const int error = rename_to_free(file, kept);
    if (error == 0) return kept;
    if (error != EEXIST) throw fs::filesystem_error("put aside", file, kept, {error, std::generic_category()});
  }
}

}  // namespace cagewright::host
