// SPDX-License-Identifier: BSD-3-Clause
#include "host/app/scene_lock.h"

#include <QSysInfo>
#include <string>

namespace cagewright::host {
namespace {

std::string file_name(const std::filesystem::path& scene) {
  std::string name = ".";
  name.append(scene.filename().string()).append(".lock");
  return (scene.parent_path() / name).string();
}

std::unique_ptr<QLockFile> lock_of(const std::filesystem::path& scene) {
  auto lock = std::make_unique<QLockFile>(QString::fromStdString(file_name(scene)));
  lock->setStaleLockTime(0);  // a window may be open for days; stale is what has no process
  return lock;
}

}  // namespace

void SceneLock::take(const std::filesystem::path& scene) {
  file_.reset();
  holder_.reset();
  is_elsewhere_ = false;
  scene_ = scene;
  if (scene.empty()) return;
  file_ = lock_of(scene);
  is_elsewhere_ = true;
  take_again();
}

void SceneLock::take_again() {
  if (!is_elsewhere_) return;
  is_elsewhere_ = !file_->tryLock() && file_->error() == QLockFile::LockFailedError;
  holder_ = is_elsewhere_ ? read_holder() : std::nullopt;
}

std::optional<SceneLock::Holder> SceneLock::read_holder() const {
  Holder holder;
  if (!file_->getLockInfo(&holder.process, &holder.machine, &holder.program)) return {};
  return holder;
}

bool SceneLock::is_doubtful() const {
  return is_elsewhere_ && (!holder_ || holder_->machine != QSysInfo::machineHostName());
}

bool SceneLock::take_by_force() {
  if (!file_) return false;
  if (read_holder() == holder_) file_->removeStaleLockFile();
  take_again();
  return !is_elsewhere_;
}

std::filesystem::path SceneLock::file() const { return file_name(scene_); }

std::string SceneLock::holder() const {
  std::string file = "(";
  file.append(this->file().filename().string()).append(")");
  if (!holder_) return file;
  std::string who = "process ";
  return who.append(std::to_string(holder_->process))
      .append(" on ")
      .append(holder_->machine.toStdString())
      .append(" ")
      .append(file);
}

}  // namespace cagewright::host
