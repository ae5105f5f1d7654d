// SPDX-License-Identifier: BSD-3-Clause
// Opening, and what is asked about locks and autosaves that are beside a scene.
#include <QMessageBox>
#include <QPushButton>
#include <QStatusBar>
#include <chrono>
#include <system_error>

#include "host/app/age_text.h"
#include "host/app/main_window.h"
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

}  // namespace

void MainWindow::open(const fs::path& path) {
  if (!may_lose_changes()) return;
  const fs::path scene = fs::absolute(path);
  fs::path saved_as = scene;
  if (!is_scene_name(scene)) saved_as.replace_extension(".glb");
  std::optional<fs::path> left = autosave_->claim(saved_as);
  if (!may_open_locked(left)) return autosave_->give_up_claim();
  bool recovers = false;
  if (left) {
    const std::optional<bool> answer = ask_to_recover(*left, saved_as);
    if (!answer) return autosave_->give_up_claim();
    recovers = *answer;
  }
  const bool is_open = recovers ? editor_->attempt([&] { editor_->workspace().recover(*left, saved_as); })
                                : editor_->run({{"command", "open"}, {"path", scene.string()}});
  if (!is_open) {
    autosave_->give_up_claim();
    return show_not_opened(statusBar()->currentMessage());
  }
  remember(scene);
  if (recovers) autosave_->keep_recovered();
  std::string notes;
  const auto add = [&notes](const std::string& note) { notes += (notes.empty() ? "" : "; ") + note; };
  if (autosave_->is_open_elsewhere())
    add(saved_as.filename().string() + " is open in another window, too, " + autosave_->open_elsewhere_by() +
        ": who saves last wins, and only there changes survive a crash. Save As gives it a name of its own");
  if (left && !recovers) {
    try {
      add("what was not saved before is in " + Autosave::put_aside(saved_as).filename().string());
    } catch (const fs::filesystem_error& error) {
      add("what was not saved before could not be put aside: " + error.code().message());
    }
  }
  for (const std::string& note : editor_->workspace().notes()) add(note);
  if (!notes.empty()) say_warning(notes);
}

// Somebody may not look at the line at the bottom, which says it, too. Nothing waits for the answer, and what opens
// meanwhile takes the box away.
void MainWindow::show_not_opened(const QString& sentence) {
  auto* box = new QMessageBox(QMessageBox::Warning, "Not opened", sentence, QMessageBox::Ok, this);
  box->setAttribute(Qt::WA_DeleteOnClose);
  not_opened_ = box;
  box->open();
}

bool MainWindow::may_open_locked(std::optional<fs::path>& left) {
  if (!autosave_->is_claim_doubtful()) return true;
  const SceneLock& lock = autosave_->claimed_lock();
  QMessageBox box(QMessageBox::Question, "Open elsewhere?",
                  QString("%1 may be open in another window, %2.")
                      .arg(text_of(lock.scene().filename()), QString::fromStdString(lock.holder())),
                  QMessageBox::Cancel, this);
  box.setInformativeText(
      QString("Whether that window is still there cannot be told from this machine. Where it is gone, remove its lock, "
              "%1: else no autosave is written here. Where it is not, who saves last wins.")
          .arg(text_of(lock.file())));
  QPushButton* anyway = box.addButton("Open Anyway", QMessageBox::AcceptRole);
  QPushButton* removing = box.addButton("Remove Lock and Open", QMessageBox::AcceptRole);
  box.setDefaultButton(anyway);
  box.exec();
  if (box.clickedButton() == removing) left = autosave_->claim_by_force();
  return box.clickedButton() == removing || box.clickedButton() == anyway;
}

std::optional<bool> MainWindow::ask_to_recover(const fs::path& left, const fs::path& scene) {
  std::error_code none;
  const auto answer = QMessageBox::question(
      this, "Recover changes?",
      QString("The program ended before %1 was saved. What was not saved was last written %2. Recover it?\n\n"
              "No opens %3, and keeps what was not saved beside it, as %4.")
          .arg(text_of(scene.filename()), QString::fromStdString(age_text(age_of(left))),
               fs::exists(scene, none) ? "the scene as it was saved" : "the model, of which no scene was saved",
               text_of(Autosave::free_name_aside(scene).filename())),
      QMessageBox::Yes | QMessageBox::No | QMessageBox::Cancel, QMessageBox::Yes);
  if (answer == QMessageBox::Cancel) return {};
  return answer == QMessageBox::Yes;
}

}  // namespace cagewright::host
