// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_APP_VALIDATION_DIALOG_H
#define CAGEWRIGHT_HOST_APP_VALIDATION_DIALOG_H

#include <QDialog>
#include <QProcess>
#include <QTemporaryDir>

#include "host/app/editor.h"

class QDialogButtonBox;
class QPlainTextEdit;
class QPushButton;
class QSpinBox;

namespace cagewright::host {

// `cagewright validate` of the scene as it is now, in a process of its own: it takes minutes, and the window goes on.
class ValidationDialog : public QDialog {
 public:
  ValidationDialog(Editor& editor, QWidget* parent);
  ~ValidationDialog() override;

 private:
  void start();
  void finish(int exit_code, QProcess::ExitStatus status);
  QString page() const { return folder_.filePath("validation.html"); }

  Editor& editor_;
  QTemporaryDir folder_;
  QProcess process_;
  QSpinBox* seconds_;
  QPlainTextEdit* text_;
  QPushButton *start_, *show_;
};

}  // namespace cagewright::host

#endif
