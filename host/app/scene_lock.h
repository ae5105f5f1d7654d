// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_APP_SCENE_LOCK_H
#define CAGEWRIGHT_HOST_APP_SCENE_LOCK_H

#include <QLockFile>
#include <QString>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

namespace cagewright::host {

// Says which window has a scene open, by a file beside it: "." + its name + ".lock". What a process of this machine has
// left that is gone does not count; whether one of another machine is there still nobody can tell, so that counts.
// Where no such file can be written there is no lock, and none is missed.
class SceneLock {
 public:
  // Gives up the lock before. An empty path: of none.
  void take(const std::filesystem::path& scene);
  void take_again();  // where another window had it: that may have been closed since
  // Whether another window has it.
  bool is_elsewhere() const { return is_elsewhere_; }
  const std::filesystem::path& scene() const { return scene_; }
  // Whether nobody can tell if that window is still there: the lock is of another machine, or does not say of which.
  bool is_doubtful() const;
  // Takes it all the same, where it is still that of which holder() tells: that window is gone. False: it stays
  // elsewhere, for the file cannot be removed, or another window has it now, and holder() tells of that.
  bool take_by_force();
  // Who had it elsewhere when it was last tried, and by which file: "process 12 on machine (.scene.glb.lock)".
  std::string holder() const;
  std::filesystem::path file() const;  // precondition: scene() is not empty

 private:
  struct Holder {
    qint64 process = 0;
    QString machine, program;
    bool operator==(const Holder&) const = default;
  };
  std::optional<Holder> read_holder() const;  // nothing: the file does not say

  std::filesystem::path scene_;
  std::unique_ptr<QLockFile> file_;
  std::optional<Holder> holder_;  // of another window
  bool is_elsewhere_ = false;
};

}  // namespace cagewright::host

#endif
