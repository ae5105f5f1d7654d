// SPDX-License-Identifier: BSD-3-Clause
#include "host/app/file_dialog.h"

#include <QFileDialog>
#include <QLineEdit>
#include <QListView>

namespace cagewright::host {
namespace {

// While "/home/me/scenes/a.glb" is typed it is "/home/me/scenes" once, which Qt then selects in the list and does not
// deselect where that is the folder shown; a selection counts for more than the text.
void deselect_folder_shown(QFileDialog& dialog) {
  auto* typed = dialog.findChild<QLineEdit*>("fileNameEdit");
  auto* list = dialog.findChild<QListView*>("listView");
  if (!typed || !list) return;  // the desktop's own dialog
  QObject::connect(typed, &QLineEdit::textChanged, list, [list] {
    list->selectionModel()->select(list->rootIndex(), QItemSelectionModel::Deselect | QItemSelectionModel::Rows);
  });
}

QString ask(QFileDialog& dialog) {
  deselect_folder_shown(dialog);
  return dialog.exec() == QDialog::Accepted ? dialog.selectedFiles().value(0) : QString();
}

}  // namespace

QString ask_for_file_to_open(QWidget* parent, const QString& title, const QString& folder, const QString& filters) {
  QFileDialog dialog(parent, title, folder, filters);
  dialog.setFileMode(QFileDialog::ExistingFile);
  return ask(dialog);
}

QString ask_for_file_to_save(QWidget* parent, const QString& title, const QString& suggested, const QString& filters,
                             QString& filter) {
  const QFileInfo file(suggested);
  QFileDialog dialog(parent, title, file.absolutePath(), filters);
  dialog.setFileMode(QFileDialog::AnyFile);
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  if (!file.fileName().isEmpty()) dialog.selectFile(file.fileName());
  const QString name = ask(dialog);
  filter = dialog.selectedNameFilter();
  return name;
}

}  // namespace cagewright::host
