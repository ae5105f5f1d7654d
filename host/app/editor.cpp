// SPDX-License-Identifier: BSD-3-Clause
#include "host/app/editor.h"

#include <exception>
#include <utility>

namespace cagewright::host {
namespace {

constexpr int seldom_ms = 300;

}  // namespace

Editor::Editor(std::shared_ptr<const Plugin> plugin, std::function<void()> wake, ScriptRunner::ViewCommand view)
    : workspace_(std::move(plugin), std::move(wake)), script_(workspace_, std::move(view)) {
  pending_timer_.setSingleShot(true);
  pending_timer_.setInterval(seldom_ms);
  QObject::connect(&pending_timer_, &QTimer::timeout, [this] { tell_pending(); });
  workspace_.listen([this](WorkspaceChange change) { tell(change); });
}

void Editor::tell(WorkspaceChange change) {
  for (const Listener& listener : listeners_) listener(change);
  const bool is_of_drag =
      change == WorkspaceChange::slides || change == WorkspaceChange::cage || change == WorkspaceChange::progress;
  if (is_of_drag && !workspace_.preview().empty()) {
    pending_.insert(change);
    if (!pending_timer_.isActive()) pending_timer_.start();
    return;
  }
  tell_pending();
  for (const Listener& listener : seldom_) listener(change);
}

void Editor::tell_pending() {
  pending_timer_.stop();
  for (const WorkspaceChange change : std::exchange(pending_, {}))
    for (const Listener& listener : seldom_) listener(change);
}

bool Editor::run(const nlohmann::json& command) {
  return attempt([&] { run_or_throw(command); });
}

bool Editor::run_typed(const nlohmann::json& command) {
  try {
    run_or_throw(command);
  } catch (const std::exception& error) {
    refuse_typed(error.what());
    return false;
  }
  if (tell_refusal_) tell_refusal_("");
  return true;
}

void Editor::refuse_typed(const std::string& sentence) {
  if (tell_refusal_) tell_refusal_(sentence);
}

nlohmann::json Editor::run_or_throw(const nlohmann::json& command) {
  nlohmann::json said = script_.run(command);
  if (tell_done_) tell_done_(command, said);
  return said;
}

bool Editor::attempt(const std::function<void()>& action) {
  const std::size_t failures_before = failures_;
  try {
    action();
    // What an attempt within this one has told is not to be taken for done.
    if (failures_ == failures_before && tell_done_) tell_done_(nullptr, nullptr);
    return true;
  } catch (const std::exception& error) {
    ++failures_;
    if (tell_failure_) tell_failure_(error.what());
    return false;
  }
}

std::vector<std::string> Editor::selected_names() const {
  std::vector<std::string> names;
  for (const std::int64_t id : workspace_.selection())
    if (const SceneSlide* slide = workspace_.document().find_slide(id)) names.push_back(slide->name);
  return names;
}

}  // namespace cagewright::host
