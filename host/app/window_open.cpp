// SPDX-License-Identifier: BSD-3-Clause
// Opening, and what is asked about locks and autosaves that are beside a scene.
#include <QMessageBox>
#include <QPushButton>
#include <QStatusBar>
#include <chrono>
#include <system_error>

#include "host/app/age_text.h"
#include "host/app/main_window.h"
#include "host/app/put_aside.h"
#include "host/app/script_recorder.h"
#include "host/scene/scene_names.h"

namespace cagewright::host {
namespace {

namespace fs = std::filesystem;

QString text_of(const fs::path& path) { return QString::fromStdString(path.string()); }

std::chrono::seconds age_of(const fs::path& file) {
  std::error_code error;
  const auto time = fs::last_write_time(file, error);
  if (error) return {};
  return std::chrono::duration_cast<std::chrono::seconds>(fs::file_time_type::clock::now() - time);
}

// Written by somebody else: this program removes what was not saved once it has saved.
QString written_since_text(const fs::path& left, const fs::path& scene) {
  std::error_code error;
  const auto left_at = fs::last_write_time(left, error);
  if (error) return {};
  const auto scene_at = fs::last_write_time(scene, error);
  if (error || scene_at <= left_at) return {};
  return QString(" %1 itself was written since, %2: to save what was recovered replaces that.")
      .arg(text_of(scene.filename()), QString::fromStdString(age_text(age_of(scene))));
}

// What No does where it is asked whether to recover `left` of a scene.
QString no_text(const fs::path& left, const fs::path& opened, const fs::path& scene) {
  std::error_code none;
  const bool is_saved = fs::exists(scene, none), is_model = opened != scene;
  if (!is_saved && !is_model)
    return QString("%1 itself is not there: No opens nothing, and leaves what was not saved in %2.")
        .arg(text_of(scene.filename()), text_of(left.filename()));
  QString opens = "the scene as it was saved";
  if (is_model && is_saved)
    opens = QString("the model %1 alone, without what was saved in %2")
                .arg(text_of(opened.filename()), text_of(scene.filename()));
  else if (is_model)
    opens = "the model, of which no scene was saved";
  return QString("No opens %1, and keeps what was not saved beside it, as %2.")
      .arg(opens, text_of(free_name_aside(scene).filename()));
}

}  // namespace

void MainWindow::open(const fs::path& path) {
  if (!may_lose_changes()) return;
  const fs::path scene = fs::absolute(path);
  fs::path saved_as = scene;
  if (!is_scene_name(scene)) saved_as.replace_extension(".glb");
  autosave_->claim(saved_as);
  const std::optional<Left> answer = ask_before_opening(scene, saved_as);
  if (!answer) return autosave_->give_up_claim();
  const bool recovers = answer->recovers;
  const bool is_open = recovers ? editor_->attempt([&] { editor_->workspace().recover(*answer->file, saved_as); })
                                : editor_->run({{"command", "open"}, {"path", scene.string()}});
  if (!is_open) {
    autosave_->give_up_claim();
    return show_not_opened(said_.sentence);
  }
  remember(scene);
  if (recovers) {
    autosave_->keep_recovered();
    recorder_->record_scene();
  }
  std::string notes;
  const auto add = [&notes](const std::string& note) { notes += (notes.empty() ? "" : "; ") + note; };
  if (autosave_->is_open_elsewhere())
    add(saved_as.filename().string() + " is open in another window, too, " + autosave_->open_elsewhere_by() +
        ": who saves last wins, and only there changes survive a crash. Save As gives it a name of its own");
  if (answer->file && !recovers) add(autosave_->put_aside_left("what was not saved before"));
  for (const std::string& note : editor_->workspace().notes()) add(note);
  if (!notes.empty()) say_warning(notes);
}

// The other machine's lock is removed last: until everything is answered, all stays as it was. A command may open a
// scene while something is asked: then that stays.
std::optional<MainWindow::Left> MainWindow::ask_before_opening(const fs::path& opened, const fs::path& scene) {
  QString before;
  const fs::path claimed = autosave_->claimed_lock().scene();  // none where it is open already
  const auto is_claimed = [&] { return autosave_->claimed_lock().scene() == claimed; };
  for (;;) {
    const bool is_doubtful = autosave_->is_claim_doubtful();
    const std::string holder = is_doubtful ? autosave_->claimed_lock().holder() : "";
    const std::optional<bool> removes_lock = is_doubtful ? ask_to_remove_lock(before) : false;
    if (!removes_lock || !is_claimed()) return {};
    Left left{autosave_->left_of_claimed(*removes_lock)};
    if (left.file) {
      const std::optional<bool> recovers = ask_to_recover(*left.file, opened, scene);
      if (!recovers || !is_claimed()) return {};
      left.recovers = *recovers;
    }
    if (!*removes_lock || autosave_->claim_by_force()) return left;
    before = autosave_->claimed_lock().holder() == holder ? "That lock could not be removed. "
                                                          : "Since you were asked another window has taken the lock. ";
  }
}

// Somebody may not look at the line at the bottom, which says it, too. Nothing waits for the answer, and what opens
// meanwhile takes the box away.
void MainWindow::show_not_opened(const QString& sentence) {
  auto* box = new QMessageBox(QMessageBox::Warning, "Not opened", sentence, QMessageBox::Ok, this);
  box->setAttribute(Qt::WA_DeleteOnClose);
  not_opened_ = box;
  box->open();
}

std::optional<bool> MainWindow::ask_to_remove_lock(const QString& before) {
  const SceneLock& lock = autosave_->claimed_lock();
  QMessageBox box(QMessageBox::Question, "Open elsewhere?",
                  before + QString("%1 may be open in another window, %2.")
                               .arg(text_of(lock.scene().filename()), QString::fromStdString(lock.holder())),
                  QMessageBox::Cancel, this);
  box.setInformativeText(
      QString("Whether that window is still there cannot be told from this machine. Where it is gone, remove its lock, "
              "%1: else no autosave is written here. Where it is not, who saves last wins; and with the lock removed "
              "the two windows write over each other's autosave, too.")
          .arg(text_of(lock.file())));
  QPushButton* anyway = box.addButton("Open Anyway", QMessageBox::AcceptRole);
  QPushButton* removing = box.addButton("Remove Lock and Open", QMessageBox::AcceptRole);
  box.setDefaultButton(anyway);
  box.exec();
  if (box.clickedButton() != removing && box.clickedButton() != anyway) return {};
  return box.clickedButton() == removing;
}

std::optional<bool> MainWindow::ask_to_recover(const fs::path& left, const fs::path& opened, const fs::path& scene) {
  const QString since = written_since_text(left, scene);
  const auto answer = QMessageBox::question(
      this, "Recover changes?",
      QString("The program ended before %1 was saved. What was not saved was last written %2.%3 Recover it?\n\n%4")
          .arg(text_of(scene.filename()), QString::fromStdString(age_text(age_of(left))), since,
               no_text(left, opened, scene)),
      QMessageBox::Yes | QMessageBox::No | QMessageBox::Cancel, since.isEmpty() ? QMessageBox::Yes : QMessageBox::No);
  if (answer == QMessageBox::Cancel) return {};
  return answer == QMessageBox::Yes;
}

}  // namespace cagewright::host
