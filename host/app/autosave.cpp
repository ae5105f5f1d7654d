// SPDX-License-Identifier: BSD-3-Clause
#include "host/app/autosave.h"

#include <exception>
#include <system_error>
#include <utility>

#include "host/app/put_aside.h"

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

void Autosave::claim(const fs::path& scene) {
  if (scene != lock_.scene()) claimed_.take(scene);
}

std::optional<fs::path> Autosave::left_of_claimed(bool is_gone) const {
  const fs::path& scene = claimed_.scene();
  if (scene.empty() || (claimed_.is_elsewhere() && !is_gone)) return {};
  const fs::path file = file_for(scene);
  std::error_code none;
  return fs::exists(file, none) ? std::optional(file) : std::nullopt;
}

void Autosave::take_lock() {
  if (claimed_.scene() == scene_ && !scene_.empty())
    lock_ = std::move(claimed_);
  else
    lock_.take(scene_);
  claimed_ = {};
  told_in_the_way_ = false;
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
  std::string what = "what was not saved before";
  if (lock_.is_elsewhere()) {
    lock_.take_again();
    if (lock_.is_elsewhere()) return false;
    if (lock_taken_) lock_taken_();
    what = "another window ended before it had saved " + scene_.filename().string() + ": what it had";
  }
  // A folder is nothing that an autosave could replace.
  const auto is_in_the_way = [this] {
    std::error_code none;
    return !is_ours_ && fs::is_regular_file(file_for(scene_), none);
  };
  if (!is_in_the_way()) return true;
  const std::string said = put_aside_left(what);
  if (!said.empty() && tell_failure_) tell_failure_(said);
  return !is_in_the_way();
}

std::string Autosave::put_aside_left(const std::string& what) {
  try {
    std::string said = what + " is in " + put_aside(file_for(scene_), scene_).filename().string() + " now";
    told_in_the_way_ = false;
    return said;
  } catch (const fs::filesystem_error& error) {
    const std::string file = file_for(scene_).filename().string();
    if (error.code() == std::errc::no_such_file_or_directory)
      return what + " is gone: another program has removed " + file;
    if (std::exchange(told_in_the_way_, true)) return {};
    return what + " stays in " + file + " (" + error.code().message() +
           "): Save As under another name, here no autosave is written";
  }
}

void Autosave::write() {
  if (!editor_.workspace().has_scene() || editor_.workspace().is_saved()) return;
  is_due_ = writer_.joinable();
  if (is_due_) return;  // what it writes is no other window's
  if (!may_write()) return timer_.start(delay_);
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
