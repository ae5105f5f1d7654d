// SPDX-License-Identifier: BSD-3-Clause
#include "host/app/scene_lock.h"

#include <QString>
#include <string>

namespace cagewright::host {
namespace {

std::unique_ptr<QLockFile> lock_of(const std::filesystem::path& scene) {
  std::string name = ".";
  name.append(scene.filename().string()).append(".lock");
  auto lock = std::make_unique<QLockFile>(QString::fromStdString((scene.parent_path() / name).string()));
  lock->setStaleLockTime(0);  // a window may be open for days; stale is what has no process
  return lock;
}

}  // namespace

bool SceneLock::is_held(const std::filesystem::path& scene) {
  const auto lock = lock_of(scene);
  return !lock->tryLock() && lock->error() == QLockFile::LockFailedError;
}

void SceneLock::take(const std::filesystem::path& scene) {
  file_.reset();
  is_elsewhere_ = false;
  if (scene.empty()) return;
  file_ = lock_of(scene);
  is_elsewhere_ = true;
  take_again();
}

void SceneLock::take_again() {
  if (is_elsewhere_) is_elsewhere_ = !file_->tryLock() && file_->error() == QLockFile::LockFailedError;
}

}  // namespace cagewright::host
