// SPDX-License-Identifier: BSD-3-Clause
// Scripts that the window records and runs, and the validation.
#include <QAction>
#include <QApplication>
#include <QFile>
#include <QMessageBox>
#include <QProgressDialog>
#include <QTimer>
#include <exception>
#include <utility>

#include "host/app/file_dialog.h"
#include "host/app/main_window.h"
#include "host/app/validation_dialog.h"
#include "host/plugin_client/plugin_error.h"

namespace cagewright::host {
namespace {

std::string path_name(const QString& file) { return std::filesystem::path(file.toStdString()).filename().string(); }

}  // namespace

void MainWindow::record_script() {
  if (recorder_->is_recording()) return record({});
  const Workspace& workspace = editor_->workspace();
  const std::filesystem::path folder = workspace.has_scene() ? workspace.path().parent_path() : "";
  const QString script =
      choose_name("Record a script", folder.empty() ? folder : folder / "", "Scripts (*.jsonl);;All files (*)");
  record_->setChecked(false);
  if (script.isEmpty()) return;
  try {
    record(script.toStdString());
  } catch (const std::exception& error) {
    QMessageBox::warning(this, "Not recorded", error.what());
  }
}

void MainWindow::record(const std::filesystem::path& path) {
  const bool was_recording = recorder_->is_recording();
  recorder_->stop();
  record_->setChecked(false);
  if (path.empty()) {
    if (was_recording) say_done("The recording is ended");
    return;
  }
  recorder_->start(path);
  record_->setChecked(true);
  say_done("Recording to " + path.filename().string());
}

void MainWindow::run_script() {
  const QString name = ask_for_file_to_open(this, "Run a script", "", "Scripts (*.jsonl);;All files (*)");
  if (name.isEmpty() || !may_lose_changes()) return;
  QFile file(name);
  if (!file.open(QIODevice::ReadOnly))
    return say_failure("The script cannot be read: " + file.errorString().toStdString());
  std::vector<ScriptLine> lines;
  for (int number = 1; !file.atEnd(); ++number) {
    std::string text = file.readLine().trimmed().toStdString();
    if (!is_blank_script_line(text)) lines.push_back({number, std::move(text)});
  }
  run_lines(lines, name);
}

// Between two commands, and while one waits for the cage or draws frames, the box is painted and its button heard.
void MainWindow::run_lines(const std::vector<ScriptLine>& lines, const QString& name) {
  const std::string file = path_name(name);
  QProgressDialog box(QString("Running %1 ...").arg(QString::fromStdString(file)), "Cancel", 0,
                      static_cast<int>(lines.size()), this);
  box.setWindowTitle("Run Script");
  box.setWindowModality(Qt::ApplicationModal);
  box.show();
  const auto is_cancelled = [&box] {
    QApplication::processEvents();
    return box.wasCanceled();
  };
  editor_->script().interrupt_where(is_cancelled);
  int done = 0;
  for (const ScriptLine& line : lines) {
    box.setValue(done);
    try {
      if (!run_line(line.text, is_cancelled)) break;
      ++done;
    } catch (const Cancelled&) {
      break;
    } catch (const std::exception& error) {
      QMessageBox::warning(this, "The script stopped",
                           QString("%1, line %2: %3").arg(name).arg(line.number).arg(error.what()));
      break;
    }
  }
  editor_->script().interrupt_where({});
  const std::string commands = lines.size() == 1 ? " command of " : " commands of ";
  const std::string all = std::to_string(lines.size()) + commands + file;
  if (done == static_cast<int>(lines.size())) return say_done("Ran " + all);
  say_done("Stopped after " + std::to_string(done) + " of " + all + "; Undo takes back what they did to the scene");
}

bool MainWindow::run_line(const std::string& line, const std::function<bool()>& is_cancelled) {
  const nlohmann::json command = parse_script_line(line);
  const Workspace& workspace = editor_->workspace();
  const bool waits = ScriptRunner::waits_for_cage(command);
  const auto has_to_wait = [&] {
    return waits && (workspace.progress().is_solving || workspace.has_to_wait_to_save());
  };
  if (is_cancelled()) return false;
  QTimer wake;
  wake.start(50);
  while (has_to_wait()) {
    QApplication::processEvents(QEventLoop::WaitForMoreEvents);
    if (is_cancelled()) return false;
  }
  editor_->run_or_throw(command);
  return true;
}

void MainWindow::validate() {
  if (!editor_->workspace().plugin()) return say_failure("No plug-in is loaded: File > Plug-ins loads one.");
  auto* dialog = new ValidationDialog(*editor_, this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->show();
}

}  // namespace cagewright::host
