// SPDX-License-Identifier: BSD-3-Clause
#include "host/app/scene_lock.h"

#include <QString>
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
  is_elsewhere_ = false;
  scene_ = scene;
  if (scene.empty()) return;
  file_ = lock_of(scene);
  is_elsewhere_ = true;
  take_again();
}

void SceneLock::take_again() {
  if (is_elsewhere_) is_elsewhere_ = !file_->tryLock() && file_->error() == QLockFile::LockFailedError;
}

bool SceneLock::is_doubtful() const {
  qint64 process = 0;
  QString machine, program;
  return is_elsewhere_ && (!file_->getLockInfo(&process, &machine, &program) || machine != QSysInfo::machineHostName());
}

void SceneLock::take_by_force() {
  file_->removeStaleLockFile();
  take_again();
}

std::filesystem::path SceneLock::file() const { return file_name(scene_); }

std::string SceneLock::holder() const {
  qint64 process = 0;
  QString machine, program;
  std::string file = "(";
  file.append(this->file().filename().string()).append(")");
  if (!file_ || !file_->getLockInfo(&process, &machine, &program)) return file;
  std::string who = "process ";
  return who.append(std::to_string(process)).append(" on ").append(machine.toStdString()).append(" ").append(file);
}

}  // namespace cagewright::host
