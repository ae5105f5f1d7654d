// SPDX-License-Identifier: BSD-3-Clause
// Saving, exporting and copying from the window, and the questions that go with it.
#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QFileDialog>
#include <QInputDialog>
#include <QMenu>
#include <QMessageBox>
#include <QProgressDialog>
#include <QPushButton>
#include <QSettings>
#include <QTimer>
#include <exception>
#include <system_error>

#include "host/app/file_dialog.h"
#include "host/app/file_ending.h"
#include "host/app/main_window.h"
#include "host/app/turntable_text.h"
#include "host/app/view_widget.h"
#include "host/plugin_client/plugin_error.h"
#include "host/workspace/slide_names.h"

namespace cagewright::host {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr int most_recent = 10;
constexpr const char* first_help =
    "<b>Draw your first cut slide</b><br>Take <b>Draw Slides (D)</b> and draw a short stroke across a limb, or click "
    "on it. "
    "The cage follows. A slide wherever a limb bends or changes its girth is enough: wrist, elbow, shoulder, neck "
    "...<br>"
    "Alt + mouse turns the view, F1 lists all keys.";

fs::path path_of(const QString& file) { return fs::path(file.toStdString()); }
// None: it is not there.
std::optional<fs::file_time_type> time_of(const fs::path& file) {
  std::error_code error;
  const auto time = fs::last_write_time(file, error);
  return error ? std::nullopt : std::optional(time);
}
QString text_of(const fs::path& path) { return QString::fromStdString(path.string()); }

// Those on the clipboard; empty: it holds something else, or nothing. Only where somebody pastes: its owner is another
// program, for whose answer the window waits, and one that hangs takes 15 seconds.
json copied_slides() {
  const QString text = QApplication::clipboard()->text();
  if (!text.trimmed().startsWith('{')) return json::array();  // most of what people copy
  json copied = json::parse(text.toStdString(), nullptr, false);
  if (!copied.is_object() || !copied.contains("slides") || !copied["slides"].is_array()) return json::array();
  return copied["slides"];
}

}  // namespace

void MainWindow::show_first_help() {
  // It would cover what is drawn on; the line at the bottom goes on with what it says.
  const Workspace& workspace = editor_->workspace();
  const bool is_wanted = workspace.has_scene() && workspace.mesh_node() >= 0 && workspace.slides().empty() &&
                         !workspace.cage().failed && !view_->is_drawing() &&
                         !QSettings().value("knows_slides", false).toBool();
  view_->show_help(is_wanted ? first_help : "");
}

void MainWindow::finish_first_run() {
  if (editor_->workspace().has_scene() && !editor_->workspace().slides().empty()) {
    QSettings().setValue("knows_slides", true);
    view_->show_help("");
  }
}

// A number that is typed and not ended yet counts.
void MainWindow::finish_typing() {
  if (QWidget* typed_in = QApplication::focusWidget()) typed_in->clearFocus();
  view_->setFocus();
}

bool MainWindow::may_lose_changes() {
  finish_typing();
  if (!editor_->workspace().has_scene() || editor_->workspace().is_saved()) return true;
  const auto answer = QMessageBox::question(
      this, "Unsaved changes",
      QString("%1 has changes that are not saved.").arg(text_of(editor_->workspace().path().filename())),
      QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, QMessageBox::Save);
  if (answer == QMessageBox::Save) return save();
  return answer == QMessageBox::Discard;
}

void MainWindow::choose_file() {
  const QString file = ask_for_file_to_open(this, "Open", QSettings().value("folder").toString(),
                                            "Scenes and models (*.glb *.gltf *.obj *.off *.ply *.stl);;All files (*)");
  if (file.isEmpty()) return;
  QSettings().setValue("folder", text_of(path_of(file).parent_path()));
  open(path_of(file));
}

// With a box that tells how far it has come and can be cancelled; false: it was, or another scene is open.
bool MainWindow::wait_for_cage() {
  finish_typing();
  Workspace& workspace = editor_->workspace();
  if (!workspace.has_to_wait_to_save()) return true;
  const fs::path scene = workspace.path();
  QProgressDialog box("Making the cage that is to be saved ...", "Cancel", 0, 1000, this);
  box.setWindowModality(Qt::ApplicationModal);
  box.show();
  QTimer wake;
  wake.start(50);
  while (workspace.has_to_wait_to_save() && !box.wasCanceled()) {
    box.setValue(static_cast<int>(999 * workspace.progress().fraction));
    QApplication::processEvents(QEventLoop::WaitForMoreEvents);
  }
  return !box.wasCanceled() && workspace.has_scene() && workspace.path() == scene;
}

bool MainWindow::save() {
  if (!wait_for_cage()) return false;
  const Workspace& workspace = editor_->workspace();
  std::error_code none;
  // Of a model: what has that name already is another scene.
  if (!workspace.has_file() && fs::exists(workspace.path(), none)) return save_as();
  const auto time = time_of(workspace.path());
  if (workspace.has_file() && time && time != on_disk_) return save_over_another(workspace.path());
  return save_to(workspace.path());
}

void MainWindow::note_file() {
  const Workspace& workspace = editor_->workspace();
  on_disk_ = workspace.has_scene() ? time_of(workspace.path()) : std::nullopt;
}

bool MainWindow::save_over_another(const fs::path& scene) {
  QMessageBox box(QMessageBox::Question, "Changed by another",
                  QString("%1 is not what this window has opened or saved: another program or window has written it. "
                          "Write over it?")
                      .arg(text_of(scene.filename())),
                  QMessageBox::Yes | QMessageBox::No, this);
  QPushButton* elsewhere = box.addButton("Save &As ...", QMessageBox::AcceptRole);
  box.setDefaultButton(QMessageBox::No);
  const int answer = box.exec();
  if (box.clickedButton() == elsewhere) return save_as();
  return answer == QMessageBox::Yes && save_to(scene);
}

// Empty: it went well; else why it did not.
QString MainWindow::why_not_done(const json& command) {
  std::string why;
  QGuiApplication::setOverrideCursor(Qt::WaitCursor);
  try {
    editor_->run_or_throw(command);
  } catch (const std::exception& error) {
    why = without_echo(error.what());
  }
  QGuiApplication::restoreOverrideCursor();
  return QString::fromStdString(why);
}

// What somebody has asked for with a file dialog: a failure gets a box, for a line may be missed.
bool MainWindow::write(const json& command, const QString& failure) {
  const QString why = why_not_done(command);
  if (!why.isEmpty()) QMessageBox::warning(this, failure, why);
  return why.isEmpty();
}

bool MainWindow::save_to(const fs::path& path) {
  const QString why = why_not_done({{"command", "save"}, {"path", path.string()}});
  if (why.isEmpty()) {
    remember(path);
    return true;
  }
  QMessageBox box(QMessageBox::Warning, "Not saved", why, QMessageBox::Ok, this);
  const QPushButton* elsewhere = box.addButton("Save &As ...", QMessageBox::AcceptRole);
  box.setDefaultButton(QMessageBox::Ok);
  box.setEscapeButton(QMessageBox::Ok);
  box.exec();
  return box.clickedButton() == elsewhere && save_as();
}

// The dialog has asked about the name as it was typed, not about that with the filter's ending.
QString MainWindow::choose_name(const QString& title, const fs::path& suggested, const QString& filters) {
  QString filter;
  const QString typed = ask_for_file_to_save(this, title, text_of(suggested), filters, filter);
  if (typed.isEmpty()) return {};
  const QString named = with_ending_of(filter, typed);
  std::error_code none;
  if (named == typed || !fs::exists(path_of(named), none)) return named;
  const auto answer = QMessageBox::question(
      this, "Replace it?", QString("%1 is there already. Write over it?").arg(text_of(path_of(named).filename())),
      QMessageBox::Yes | QMessageBox::No, QMessageBox::No);
  return answer == QMessageBox::Yes ? named : QString();
}

bool MainWindow::save_as() {
  const QString file = choose_name("Save as", editor_->workspace().path(), "glTF, binary (*.glb);;glTF, text (*.gltf)");
  return !file.isEmpty() && wait_for_cage() && save_to(path_of(file));
}

void MainWindow::export_cage() {
  fs::path suggested = editor_->workspace().path();
  suggested.replace_filename(suggested.stem().string() + "_cage.obj");
  const QString file = choose_name("Export the cage", suggested, "Meshes (*.obj *.off *.ply *.stl *.glb *.gltf)");
  if (!file.isEmpty() && wait_for_cage())
    write({{"command", "export_cage"}, {"path", file.toStdString()}}, "Not exported");
}

void MainWindow::export_picture() {
  fs::path suggested = editor_->workspace().path();
  suggested.replace_extension(".png");
  const QString file = choose_name("Export a picture", suggested, "Pictures (*.png)");
  if (!file.isEmpty() && wait_for_cage())
    write({{"command", "picture"}, {"path", file.toStdString()}, {"up", view_->up()}}, "Not exported");
}

void MainWindow::export_turntable() {
  const QString folder = QFileDialog::getExistingDirectory(this, "Folder for the turntable's frames");
  if (folder.isEmpty()) return;
  bool is_given = false;
  const int frames = QInputDialog::getInt(this, "Turntable", "Frames of one turn", 36, 2, 720, 1, &is_given);
  if (is_given && wait_for_cage()) draw_turntable(path_of(folder), frames);
}

// Between two frames the box is painted, and its button heard.
void MainWindow::draw_turntable(const fs::path& folder, int frames) {
  QProgressDialog box(QString("Drawing %1 frames ...").arg(frames), "Cancel", 0, frames, this);
  box.setWindowTitle("Turntable");
  box.setWindowModality(Qt::ApplicationModal);
  box.setMinimumDuration(0);
  int drawn = -1;
  editor_->script().interrupt_where([&] {
    box.setValue(++drawn);
    QApplication::processEvents();
    return box.wasCanceled();
  });
  const std::string all = std::to_string(frames);
  try {
    editor_->run_or_throw(
        {{"command", "turntable"}, {"folder", folder.string()}, {"frames", frames}, {"up", view_->up()}});
  } catch (const Cancelled&) {
    say_done(cancelled_turntable_text(drawn, frames, folder.string()));
  } catch (const std::exception& error) {
    box.reset();
    const std::string before =
        drawn > 0 ? "; " + std::to_string(drawn) + " of " + all + " frames were written before" : "";
    QMessageBox::warning(this, "Not exported", QString::fromStdString(error.what() + before));
  }
  editor_->script().interrupt_where({});
}

void MainWindow::remember(const fs::path& path) {
  QSettings settings;
  QStringList recent = settings.value("recent").toStringList();
  std::error_code none;
  if (!fs::exists(path, none)) return;  // of a model that is not saved as a scene yet
  recent.removeAll(text_of(path));
  recent.prepend(text_of(path));
  while (recent.size() > most_recent) recent.removeLast();
  settings.setValue("recent", recent);
}

void MainWindow::fill_recent() {
  recent_->clear();
  const QStringList recent = QSettings().value("recent").toStringList();
  for (const QString& file : recent)
    connect(recent_->addAction(file), &QAction::triggered, this, [this, file] { open(path_of(file)); });
  if (recent.isEmpty()) recent_->addAction("None yet")->setEnabled(false);
}

// As the text of a slides file, so that a text editor can take it, too.
void MainWindow::copy_slides() {
  const std::vector<std::int64_t>& selection = editor_->workspace().selection();
  const bool is_copied = editor_->attempt(
      [&] { QApplication::clipboard()->setText(QString::fromStdString(editor_->workspace().copy_slides(selection))); });
  if (is_copied)
    say_done(selection.size() == 1 ? "Copied 1 slide" : "Copied " + std::to_string(selection.size()) + " slides");
}

void MainWindow::paste_slides() {
  const json slides = copied_slides();
  if (slides.empty())
    return say_failure(
        "The clipboard holds no slides: select some, here or in another window, and copy them with Ctrl+C first.");
  const std::string count = std::to_string(slides.size()) + (slides.size() == 1 ? " slide" : " slides");
  if (editor_->run({{"command", "paste_slides"}, {"slides", slides}})) say_done("Pasted " + count);
}

}  // namespace cagewright::host
