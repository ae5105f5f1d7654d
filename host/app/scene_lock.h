// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_APP_SCENE_LOCK_H
#define CAGEWRIGHT_HOST_APP_SCENE_LOCK_H

#include <QLockFile>
#include <filesystem>
#include <memory>

namespace cagewright::host {

// Says which window has a scene open, by a file beside it: "." + its name + ".lock". What a process that is gone has
// left does not count. Where no such file can be written there is no lock, and none is missed.
class SceneLock {
 public:
  static bool is_held(const std::filesystem::path& scene);  // by any window, this one's too

  // Gives up the lock before. An empty path: of none.
  void take(const std::filesystem::path& scene);
  void take_again();  // where another window had it: that may have been closed since
  // Whether another window has it.
  bool is_elsewhere() const { return is_elsewhere_; }

 private:
  std::unique_ptr<QLockFile> file_;
  bool is_elsewhere_ = false;
};

}  // namespace cagewright::host

#endif
