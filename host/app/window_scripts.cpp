// SPDX-License-Identifier: BSD-3-Clause
// Scripts that the window records and runs, and the validation.
#include <QAction>
#include <QFile>
#include <QFileDialog>
#include <QMessageBox>
#include <exception>

#include "host/app/main_window.h"
#include "host/app/validation_dialog.h"

namespace cagewright::host {
namespace {

std::string path_name(const QString& file) { return std::filesystem::path(file.toStdString()).filename().string(); }

}  // namespace

void MainWindow::record_script() {
  if (recorder_->is_recording()) return record({});
  record(QFileDialog::getSaveFileName(this, "Record a script", "", "Scripts (*.jsonl);;All files (*)").toStdString());
}

void MainWindow::record(const std::filesystem::path& path) {
  const bool was_recording = recorder_->is_recording();
  recorder_->stop();
  if (!path.empty()) {
    if (editor_->attempt([&] { recorder_->start(path); })) say_done("Recording to " + path.filename().string());
  } else if (was_recording) {
    say_done("The recording is ended");
  }
  record_->setChecked(recorder_->is_recording());
}

void MainWindow::run_script() {
  const QString name = QFileDialog::getOpenFileName(this, "Run a script", "", "Scripts (*.jsonl);;All files (*)");
  if (name.isEmpty() || !may_lose_changes()) return;
  QFile file(name);
  if (!file.open(QIODevice::ReadOnly))
    return say_failure("The script cannot be read: " + file.errorString().toStdString());
  int number = 0, count = 0;
  while (!file.atEnd()) {
    const QByteArray line = file.readLine().trimmed();
    ++number;
    if (line.isEmpty() || line.startsWith('#')) continue;
    try {
      editor_->run_or_throw(nlohmann::json::parse(line.constData()));
      ++count;
    } catch (const std::exception& error) {
      QMessageBox::warning(this, "The script stopped",
                           QString("%1, line %2: %3").arg(name).arg(number).arg(error.what()));
      return;
    }
  }
  say_done("Ran " + std::to_string(count) + (count == 1 ? " command of " : " commands of ") + path_name(name));
}

void MainWindow::validate() {
  if (!editor_->workspace().plugin()) return say_failure("No plug-in is loaded: File > Plug-ins loads one.");
  auto* dialog = new ValidationDialog(*editor_, this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->show();
}

}  // namespace cagewright::host
