// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_FILE_ATOMIC_FILE_H
#define CAGEWRIGHT_HOST_FILE_ATOMIC_FILE_H

#include <filesystem>
#include <string_view>

namespace cagewright::host {

// Throws FileError where `path` could not be written as things are: its folder is missing or not writable, or it is a
// folder itself. Writes nothing. So that a program can say so before it works for long.
void require_writable(const std::filesystem::path& path);

// A file that is wholly on disk under another name in the same folder, until commit() gives it its own: whoever looks
// at `path` sees the old file or the whole new one. Gone without a trace where commit() was not called. An existing
// file keeps its permissions, a link stays a link. What is no regular file (/dev/stdout) is written at commit().
class AtomicFile {
 public:
  // `bytes` is borrowed for the life of the object. Throws FileError.
  AtomicFile(std::filesystem::path path, std::string_view bytes);
  ~AtomicFile();
  AtomicFile(AtomicFile&& other) noexcept;
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;
  AtomicFile& operator=(AtomicFile&&) = delete;

  // Once. Throws FileError; then the old file is untouched.
  void commit();

 private:
  std::filesystem::path path_;       // as the user named it
  std::filesystem::path target_;     // with links followed
  std::filesystem::path temporary_;  // empty: nothing to remove
  std::string_view bytes_;
};

// The whole of it in one call. Throws FileError.
void write_atomically(const std::filesystem::path& path, std::string_view bytes);

}  // namespace cagewright::host

#endif
