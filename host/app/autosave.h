// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_APP_AUTOSAVE_H
#define CAGEWRIGHT_HOST_APP_AUTOSAVE_H

#include <QTimer>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <thread>

#include "host/app/editor.h"
#include "host/app/scene_lock.h"

namespace cagewright::host {

// Writes what is not saved yet into a file beside the scene's: "." + its name + ".autosave.glb", which is removed when
// the scene is saved or closed. What is left there has outlived a crash. Written on a thread of its own: with a million
// triangles it takes half a second, in which a drag would stand still. Of a scene that another window has open, that
// one's autosave is left alone: nothing is written here, until it is closed or this one is saved elsewhere. What was
// left there by a window that is gone is never written over.
class Autosave : public QObject {
 public:
  Autosave(Editor& editor, QObject* parent);
  ~Autosave() override;  // waits for what is being written
  Autosave(const Autosave&) = delete;
  Autosave& operator=(const Autosave&) = delete;

  // Milliseconds after the first change that is not written yet; 0: never. Further changes do not put it off.
  void set_delay(int milliseconds);
  static std::filesystem::path file_for(const std::filesystem::path& scene);
  // Before a scene is opened: takes its lock, so that no other window asks the same. Does nothing where the scene is
  // open already.
  void claim(const std::filesystem::path& scene);
  // Whether another window's lock kept it from that, of which nobody can tell if it is still there.
  bool is_claim_doubtful() const { return claimed_.is_doubtful(); }
  const SceneLock& claimed_lock() const { return claimed_; }
  // The autosave of what was claimed, also where the scene was written since. Nothing where there is none, or where it
  // is that of another window, unless that `is_gone`.
  std::optional<std::filesystem::path> left_of_claimed(bool is_gone) const;
  // Removes the lock of that window, which is gone, and claims again. False: see SceneLock::take_by_force.
  bool claim_by_force() { return claimed_.take_by_force(); }
  void give_up_claim() { claimed_ = {}; }  // it is not opened
  // Puts aside what is there in the place of the open scene's autosave, so that it is not offered again, and says so:
  // "WHAT is in NAME now". Where it cannot be, it says why, once, and no autosave is written until it can be.
  std::string put_aside_left(const std::string& what);
  // No autosave of the open scene any more, where this program has written or recovered one. Waits for what is being
  // written.
  void discard();
  // Whether another window has the open scene, too.
  bool is_open_elsewhere() const { return lock_.is_elsewhere(); }
  std::string open_elsewhere_by() const { return lock_.holder(); }
  void on_lock(std::function<void()> taken) { lock_taken_ = std::move(taken); }  // that another window had
  // The open scene is what was left of it: that stays until it is saved.
  void keep_recovered() { is_ours_ = true; }
  void on_failure(std::function<void(const std::string&)> tell) { tell_failure_ = std::move(tell); }

 private:
  void update(WorkspaceChange change);
  void take_lock();  // of scene_
  bool may_write();
  void write();
  void finish_writing();  // waits for it, and tells where it failed

  Editor& editor_;
  QTimer timer_;
  int delay_ = 3000;              // so that with the writing no more than 5 seconds are lost
  std::filesystem::path scene_;   // that is open
  SceneLock lock_, claimed_;      // of scene_; of what is to be opened
  bool is_ours_ = false;          // its autosave was written or recovered here
  bool told_in_the_way_ = false;  // that another's autosave could not be put aside
  std::function<void(const std::string&)> tell_failure_;
  std::function<void()> lock_taken_;

  std::thread writer_;
  std::string failure_;  // of the writer; read once it has been joined
  bool is_due_ = false;  // it was time to write while the last was still being written
  int writes_ = 0;
};

}  // namespace cagewright::host

#endif
