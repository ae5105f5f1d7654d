// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_APP_EDITOR_H
#define CAGEWRIGHT_HOST_APP_EDITOR_H

#include <QTimer>
#include <filesystem>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "host/workspace/script.h"
#include "host/workspace/workspace.h"

namespace cagewright::host {

// What all parts of the window share: the workspace, its commands, and who is told of changes and failures.
class Editor {
 public:
  // `wake` is called from the solver's thread.
  Editor(std::shared_ptr<const Plugin> plugin, std::function<void()> wake, ScriptRunner::ViewCommand view);

  Workspace& workspace() { return workspace_; }
  const Workspace& workspace() const { return workspace_; }
  ScriptRunner& script() { return script_; }

  // Runs a command of a menu; a failure is told and gives false.
  bool run(const nlohmann::json& command);
  // Runs it and lets what it throws through: for scripts.
  nlohmann::json run_or_throw(const nlohmann::json& command);
  // The same as run of what somebody has typed, where the field goes on to the next thing at once: what is refused is
  // told by on_refusal, for a click elsewhere, which succeeds, is no answer to it.
  bool run_typed(const nlohmann::json& command);
  void refuse_typed(const std::string& sentence);  // it did not come to a command
  // The same for what is no command: false where `action` threw one of the host's errors.
  bool attempt(const std::function<void()>& action);

  using Listener = std::function<void(WorkspaceChange)>;
  void listen(Listener listener) { listeners_.push_back(std::move(listener)); }
  // The same for panels: while something is dragged, changes of slides, cage and progress are told a few times a second
  // only, the last of them always.
  void listen_seldom(Listener listener) { seldom_.push_back(std::move(listener)); }
  void on_failure(std::function<void(const std::string& sentence)> tell) { tell_failure_ = std::move(tell); }
  // Of what was typed; empty: something that was typed is taken, and no refusal before counts any more.
  void on_refusal(std::function<void(const std::string& sentence)> tell) { tell_refusal_ = std::move(tell); }
  // Told of every command that went well with its answer, and, with null, of every attempt in which nothing failed.
  using Done = std::function<void(const nlohmann::json& command, const nlohmann::json& said)>;
  void on_done(Done tell) { tell_done_ = std::move(tell); }

  std::vector<std::string> selected_names() const;

 private:
  void tell(WorkspaceChange change);
  void tell_pending();

  Workspace workspace_;
  ScriptRunner script_;
  std::vector<Listener> listeners_, seldom_;
  std::set<WorkspaceChange> pending_;  // of seldom_
  QTimer pending_timer_;
  std::function<void(const std::string&)> tell_failure_, tell_refusal_;
  Done tell_done_;
  std::size_t failures_ = 0;  // that were told
};

}  // namespace cagewright::host

#endif
