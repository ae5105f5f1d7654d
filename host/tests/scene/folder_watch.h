// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_TESTS_SCENE_FOLDER_WATCH_H
#define CAGEWRIGHT_HOST_TESTS_SCENE_FOLDER_WATCH_H

#include <poll.h>
#include <sys/inotify.h>
#include <unistd.h>

#include <array>
#include <filesystem>

namespace cagewright::host::test {

// Sees what happens in a folder from its construction on.
class FolderWatch {
 public:
  explicit FolderWatch(const std::filesystem::path& folder) : descriptor_(::inotify_init1(IN_CLOEXEC | IN_NONBLOCK)) {
    ::inotify_add_watch(descriptor_, folder.c_str(), IN_CREATE | IN_MOVED_TO);
  }
  ~FolderWatch() { ::close(descriptor_); }
  FolderWatch(const FolderWatch&) = delete;
  FolderWatch& operator=(const FolderWatch&) = delete;

  // False where nothing of the kind has happened for 20 seconds.
  bool wait_for_creation() { return wait_for(IN_CREATE); }
  bool wait_for_renaming() { return wait_for(IN_MOVED_TO); }

 private:
  bool wait_for(std::uint32_t kind) {
    while ((seen_ & kind) == 0) {
      pollfd waiting = {descriptor_, POLLIN, 0};
      if (::poll(&waiting, 1, 20'000) != 1) return false;
      alignas(inotify_event) std::array<char, 4096> bytes;
      const ssize_t size = ::read(descriptor_, bytes.data(), bytes.size());
      for (ssize_t i = 0; i + static_cast<ssize_t>(sizeof(inotify_event)) <= size;) {
        const auto* event = reinterpret_cast<const inotify_event*>(bytes.data() + i);
        seen_ |= event->mask;
        i += static_cast<ssize_t>(sizeof(inotify_event) + event->len);
      }
    }
    return true;
  }

  int descriptor_;
  std::uint32_t seen_ = 0;
};

}  // namespace cagewright::host::test

#endif
