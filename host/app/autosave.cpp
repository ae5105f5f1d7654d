// SPDX-License-Identifier: BSD-3-Clause
#include "host/app/autosave.h"

#include <exception>
#include <system_error>
#include <utility>

namespace cagewright::host {
namespace fs = std::filesystem;
namespace {

constexpr char failed[] = "The autosave failed: ";

}  // namespace

Autosave::Autosave(Editor& editor, QObject* parent) : QObject(parent), editor_(editor) {
  timer_.setSingleShot(true);
  connect(&timer_, &QTimer::timeout, this, [this] { write(); });
  editor_.listen([this](WorkspaceChange change) { update(change); });
}

Autosave::~Autosave() {
  if (writer_.joinable()) writer_.join();
}

void Autosave::set_delay(int milliseconds) {
  delay_ = milliseconds;
  if (delay_ <= 0) timer_.stop();
}

fs::path Autosave::file_for(const fs::path& scene) {
  std::string name = ".";
  name.append(scene.filename().string()).append(".autosave.glb");
  return scene.parent_path() / name;
}

std::optional<fs::path> Autosave::claim(const fs::path& scene) {
  if (scene == lock_.scene()) return {};
  claimed_.take(scene);
  return left_of_claimed();
}

std::optional<fs::path> Autosave::claim_by_force() {
  claimed_.take_by_force();
  return left_of_claimed();
}

std::optional<fs::path> Autosave::left_of_claimed() const {
  if (claimed_.is_elsewhere()) return {};
  const fs::path& scene = claimed_.scene();
  const fs::path file = file_for(scene);
  std::error_code none;
  const auto written = fs::last_write_time(file, none);
  if (none) return {};
  const auto saved = fs::last_write_time(scene, none);
  if (!none && saved > written) return {};
  return file;
}

void Autosave::take_lock() {
  if (claimed_.scene() == scene_ && !scene_.empty())
    lock_ = std::move(claimed_);
  else
    lock_.take(scene_);
  claimed_ = {};
}

void Autosave::update(WorkspaceChange change) {
  const Workspace& workspace = editor_.workspace();
  if (change == WorkspaceChange::scene) {
    discard();  // of the scene before: who was to be asked was asked
    scene_ = workspace.has_scene() ? workspace.path() : fs::path();
    take_lock();
    return;
  }
  if (change == WorkspaceChange::saved && workspace.has_scene() && workspace.is_saved()) {
    discard();
    if (std::exchange(scene_, workspace.path()) != workspace.path()) take_lock();
    return;
  }
  const bool is_change = change == WorkspaceChange::slides || change == WorkspaceChange::parameters;
  if (is_change && delay_ > 0 && workspace.has_scene() && !workspace.is_saved() && !timer_.isActive())
    timer_.start(delay_);
}

bool Autosave::may_write() {
  if (!lock_.is_elsewhere()) return true;
  lock_.take_again();
  if (lock_.is_elsewhere()) return false;
  put_aside_what_is_left();
  if (lock_taken_) lock_taken_();
  return true;
}

// Of another window that had the scene open and has ended without saving or throwing away.
void Autosave::put_aside_what_is_left() {
  std::error_code error;
  if (!fs::exists(file_for(scene_), error)) return;
  std::string told = "another window ended before it had saved " + scene_.filename().string() + ": what it had ";
  try {
    told += "is in " + put_aside(scene_).filename().string() + " now";
  } catch (const fs::filesystem_error&) {
    return;
  }
  if (tell_failure_) tell_failure_(told);
}

fs::path Autosave::free_name_aside(const fs::path& scene) {
  std::error_code none;
  fs::path free;
  for (int number = 1; free.empty() || fs::exists(free, none); ++number)
    free = scene.parent_path() / (scene.stem().string() + "_recovered_" + std::to_string(number) + ".glb");
  return free;
}

fs::path Autosave::put_aside(const fs::path& scene) {
  fs::path kept = free_name_aside(scene);
  fs::rename(file_for(scene), kept);
  return kept;
}

void Autosave::write() {
  if (!editor_.workspace().has_scene() || editor_.workspace().is_saved()) return;
  if (!may_write()) return timer_.start(delay_);
  is_due_ = writer_.joinable();
  if (is_due_) return;
  std::function<void()> job;
  try {
    job = editor_.workspace().copy_to_write(file_for(scene_));
  } catch (const std::exception& error) {
    if (tell_failure_) tell_failure_(std::string(failed) + error.what());
    return;
  }
  failure_.clear();
  writer_ = std::thread([this, write_copy = std::move(job), number = ++writes_] {
    try {
      write_copy();
    } catch (const std::exception& error) {
      failure_ = error.what();
    }
    const auto go_on = [this, number] {
      if (number != writes_) return;  // discarded since
      finish_writing();
      if (is_due_) write();
    };
    QMetaObject::invokeMethod(this, go_on, Qt::QueuedConnection);
  });
}

void Autosave::finish_writing() {
  if (!writer_.joinable()) return;
  writer_.join();
  if (failure_.empty()) {
    is_ours_ = true;
  } else if (tell_failure_) {
    tell_failure_(failed + failure_);
  }
}

void Autosave::discard() {
  timer_.stop();
  is_due_ = false;
  ++writes_;
  finish_writing();
  if (!std::exchange(is_ours_, false)) return;
  std::error_code ignored;
  fs::remove(file_for(scene_), ignored);
}

}  // namespace cagewright::host
