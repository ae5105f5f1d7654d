// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_APP_AUTOSAVE_H
#define CAGEWRIGHT_HOST_APP_AUTOSAVE_H

#include <QTimer>
#include <filesystem>
#include <optional>

#include "host/app/editor.h"

namespace cagewright::host {

// Writes what is not saved yet into a file beside the scene's: "." + its name + ".autosave.glb", which is removed when
// the scene is saved or closed. What is left there has outlived a crash.
class Autosave : public QObject {
 public:
  Autosave(Editor& editor, QObject* parent);

  // Milliseconds after the first unsaved change; 0: never.
  void set_delay(int milliseconds);
  static std::filesystem::path file_for(const std::filesystem::path& scene);
  // Of an autosave that is newer than its scene, or whose scene is not there.
  static std::optional<std::filesystem::path> recoverable(const std::filesystem::path& scene);
  // No autosave of the open scene any more, where this program has written or recovered one.
  void discard();
  // The open scene is what was left of it: that stays until it is saved.
  void keep_recovered() { is_ours_ = true; }
  void on_failure(std::function<void(const std::string&)> tell) { tell_failure_ = std::move(tell); }

 private:
  void update(WorkspaceChange change);
  void write();

  Editor& editor_;
  QTimer timer_;
  int delay_ = 4000;
  std::filesystem::path scene_;  // that is open
  bool is_ours_ = false;         // its autosave was written or recovered here
  std::function<void(const std::string&)> tell_failure_;
};

}  // namespace cagewright::host

#endif
