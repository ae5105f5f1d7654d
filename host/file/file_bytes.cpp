// SPDX-License-Identifier: BSD-3-Clause
#include "host/file/file_bytes.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "host/file/file_error.h"

namespace cagewright::host {
namespace {

class OpenFile {
 public:
  explicit OpenFile(int descriptor) : descriptor_(descriptor) {}
  ~OpenFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;
  int descriptor() const { return descriptor_; }

 private:
  int descriptor_;
};

[[noreturn]] void fail(const std::filesystem::path& path, int error) {
  if (error == ENOENT) throw FileError(path, {}, "there is no such file");
  throw FileError(path, {}, "cannot be read: " + std::generic_category().message(error));
}

}  // namespace

std::string read_bytes(const std::filesystem::path& path) {
  // O_NONBLOCK: opening a pipe that nobody writes to would wait for ever.
  const OpenFile file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  if (file.descriptor() < 0) fail(path, errno);
  struct stat status {};
  if (::fstat(file.descriptor(), &status) != 0) fail(path, errno);
  if (S_ISDIR(status.st_mode)) throw FileError(path, {}, "is a folder, not a file");
  if (!S_ISREG(status.st_mode)) throw FileError(path, {}, "is a device or pipe, not a file");

  // One byte more than the size, so that a file that grew in the meantime is noticed and read to its end.
  std::string bytes(static_cast<std::size_t>(status.st_size) + 1, '\0');
  std::size_t filled = 0;
  while (true) {
    const ssize_t got = ::read(file.descriptor(), bytes.data() + filled, bytes.size() - filled);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) fail(path, errno);
    if (got == 0) break;
    filled += static_cast<std::size_t>(got);
    if (filled == bytes.size()) bytes.resize(2 * bytes.size());
  }
  bytes.resize(filled);
  return bytes;
}

std::string lower_ending(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  for (char& c : ending) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return ending;
}

}  // namespace cagewright::host
