// SPDX-License-Identifier: BSD-3-Clause
#include "host/app/script_recorder.h"

#include <exception>
#include <utility>

#include "host/file/atomic_file.h"
#include "host/file/file_error.h"

namespace cagewright::host {
namespace {

std::uint64_t state_of(const Workspace& workspace) { return workspace.has_scene() ? workspace.stack().state() : 0; }

}  // namespace

ScriptRecorder::ScriptRecorder(Editor& editor, std::function<void(const std::string&)> tell_end)
    : editor_(editor), tell_end_(std::move(tell_end)) {}

void ScriptRecorder::start(const std::filesystem::path& path) {
  stop();
  require_writable(path);
  file_.open(path, std::ios::trunc);
  if (!file_) throw FileError(path, {}, "a script cannot be written here");
  path_ = path;
  copies_.clear();
  copy_count_ = 0;
  try {
    write_scene();
  } catch (...) {
    file_.close();
    throw;
  }
  editor_.script().record([this](const nlohmann::json& command) { attempt([&] { record(command); }); });
}

void ScriptRecorder::stop() {
  editor_.script().record({});
  if (file_.is_open()) file_.close();
}

void ScriptRecorder::record_scene() {
  copies_.clear();
  if (is_recording()) attempt([this] { write_scene(); });
}

// What is recorded has been done, whether it can be written or not.
void ScriptRecorder::attempt(const std::function<void()>& action) {
  if (!is_recording()) return;
  try {
    action();
  } catch (const std::exception& error) {
    file_.close();
    tell_end_(std::string("The recording is ended: ") + error.what());
  }
}

// At once, so that a crash leaves what led to it.
void ScriptRecorder::write(const nlohmann::json& command) {
  file_ << command.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) << std::endl;
  if (!file_) throw FileError(path_, {}, "cannot be written any further");
}

void ScriptRecorder::write_scene() {
  const Workspace& workspace = editor_.workspace();
  const std::uint64_t state = state_of(workspace);
  if (workspace.has_scene()) {
    write({{"command", "open"}, {"path", copy_of(state).string()}});
    if (workspace.mesh_node() >= 0) write({{"command", "select_mesh"}, {"node", workspace.mesh_node()}});
  }
  states_ = {state};
  now_ = 0;
}

std::filesystem::path ScriptRecorder::copy_of(std::uint64_t state) {
  if (const auto found = copies_.find(state); found != copies_.end()) return found->second;
  std::filesystem::path copy = path_;
  if (copy_count_ > 0) copy.concat(".").concat(std::to_string(copy_count_ + 1));
  copy += ".glb";
  editor_.workspace().save_copy(copy);
  ++copy_count_;
  return copies_[state] = copy;
}

bool ScriptRecorder::follow(const std::string& command) {
  const std::uint64_t state = state_of(editor_.workspace());
  if (command == "undo" || command == "redo") {
    const std::size_t next = command == "redo" ? now_ + 1 : now_ - 1;  // before the first: none
    if (next >= states_.size() || states_[next] != state) return false;
    now_ = next;
  } else if (command == "open" || command == "close") {
    copies_.clear();
    states_ = {state};
    now_ = 0;
  } else if (state != states_[now_]) {
    states_.resize(++now_);
    states_.push_back(state);
  }
  return true;
}

void ScriptRecorder::record(nlohmann::json command) {
  const std::string name = command.value("command", "");
  if (!follow(name)) return write_scene();
  // A replay may have opened a copy of it.
  if (name == "save" && !command.contains("path")) command["path"] = editor_.workspace().path().string();
  write(command);
}

}  // namespace cagewright::host
