// SPDX-License-Identifier: BSD-3-Clause
#include "host/file/atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <fstream>
#include <string>
#include <system_error>
#include <utility>

#include "host/file/file_error.h"

namespace cagewright::host {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& reason) {
  throw FileError(path, {}, "cannot be written: " + reason);
}

std::string text_of(int error) { return std::generic_category().message(error); }

// Where a rename has to go so that a link stays a link.
std::filesystem::path follow_links(const std::filesystem::path& path) {
  std::error_code error;
  std::filesystem::path target = path;
  for (int hops = 0; hops < 40 && std::filesystem::is_symlink(target, error); ++hops) {
    const std::filesystem::path next = std::filesystem::read_symlink(target, error);
    if (error) fail(path, error.message());
    target = next.is_absolute() ? next : target.parent_path() / next;
  }
  return target;
}

std::filesystem::path folder_of(const std::filesystem::path& target) {
  return target.has_parent_path() ? target.parent_path() : std::filesystem::path(".");
}

// Exists and is something that a rename must not replace: a terminal, a pipe, /dev/null.
bool is_device(const std::filesystem::path& target) {
  struct stat status {};
  return ::stat(target.c_str(), &status) == 0 && !S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode);
}

// umask() can only read it by setting it, which other threads that make files would see.
mode_t process_umask() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with("Umask:")) return static_cast<mode_t>(std::stoul(line.substr(6), nullptr, 8));
  return 022;
}

// The permissions of the file that is replaced, or what the umask leaves of a new one's.
mode_t permissions(const std::filesystem::path& target) {
  struct stat status {};
  if (::stat(target.c_str(), &status) == 0) return status.st_mode & 07777;
  return 0666 & ~process_umask();
}

class Descriptor {
 public:
  Descriptor(int descriptor, const std::filesystem::path& path) : descriptor_(descriptor), path_(path) {
    if (descriptor_ < 0) fail(path_, text_of(errno));
  }
  ~Descriptor() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  void write(std::string_view bytes) {
    while (!bytes.empty()) {
      const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) fail(path_, text_of(errno));
      bytes.remove_prefix(static_cast<std::size_t>(written));
    }
  }
  void set_permissions(mode_t mode) {
    if (::fchmod(descriptor_, mode) != 0) fail(path_, text_of(errno));
  }
  void sync() {
    if (::fsync(descriptor_) != 0) fail(path_, text_of(errno));
  }
  // Network file systems report a full disk only here.
  void close() {
    if (::close(std::exchange(descriptor_, -1)) != 0) fail(path_, text_of(errno));
  }

 private:
  int descriptor_;
  const std::filesystem::path& path_;
};

}  // namespace

void require_writable(const std::filesystem::path& path) {
  const std::filesystem::path target = follow_links(path), folder = folder_of(target);
  std::error_code error;
  if (std::filesystem::is_directory(target, error)) fail(path, "it is a folder");
  if (target.filename().empty()) fail(path, "it names no file");
  if (is_device(target)) {
    if (::access(target.c_str(), W_OK) != 0) fail(path, text_of(errno));
    return;
  }
  if (!std::filesystem::is_directory(folder, error)) fail(path, "there is no folder " + folder.string());
  if (::access(folder.c_str(), W_OK | X_OK) != 0) fail(path, "in its folder, " + text_of(errno));
}

AtomicFile::AtomicFile(std::filesystem::path path, std::string_view bytes)
    : path_(std::move(path)), target_(follow_links(path_)), bytes_(bytes) {
  require_writable(path_);
  if (is_device(target_)) return;
  std::string name = (folder_of(target_) / ".").string();
  name += target_.filename().string().substr(0, 200);
  name += ".XXXXXX";
  Descriptor file(::mkostemp(name.data(), O_CLOEXEC), path_);
  temporary_ = name;
  try {
    file.write(bytes);
    file.set_permissions(permissions(target_));
    file.sync();
    file.close();
  } catch (...) {
    ::unlink(temporary_.c_str());
    throw;
  }
}

AtomicFile::AtomicFile(AtomicFile&& other) noexcept
    : path_(std::move(other.path_)),
      target_(std::move(other.target_)),
      temporary_(std::exchange(other.temporary_, {})),
      bytes_(other.bytes_) {}

AtomicFile::~AtomicFile() {
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

void AtomicFile::commit() {
  if (temporary_.empty()) {
    Descriptor device(::open(target_.c_str(), O_WRONLY | O_CLOEXEC | O_APPEND), path_);
    device.write(bytes_);
    device.close();
    return;
  }
  if (::rename(temporary_.c_str(), target_.c_str()) != 0) fail(path_, text_of(errno));
  temporary_.clear();
  // The new name is only safe once its folder is; not every file system can do that, and the file is there already.
  const int folder = ::open(folder_of(target_).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (folder < 0) return;
  ::fsync(folder);
  ::close(folder);
}

void write_atomically(const std::filesystem::path& path, std::string_view bytes) {
  AtomicFile file(path, bytes);
  file.commit();
}

}  // namespace cagewright::host
