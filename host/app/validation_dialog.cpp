// SPDX-License-Identifier: BSD-3-Clause
#include "host/app/validation_dialog.h"

#include <QCoreApplication>
#include <QDesktopServices>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QUrl>
#include <QVBoxLayout>

namespace cagewright::host {
namespace {

constexpr int wait_ms = 3000;  // for a process that was asked to end

}  // namespace

ValidationDialog::ValidationDialog(Editor& editor, QWidget* parent) : QDialog(parent), editor_(editor) {
  setObjectName("validation");
  setWindowTitle("Validate with Ceres");
  resize(620, 420);
  auto* column = new QVBoxLayout(this);
  auto* form = new QFormLayout;
  seconds_ = new QSpinBox(this);
  seconds_->setObjectName("validation_seconds");
  seconds_->setRange(0, 3600);
  seconds_->setValue(30);
  seconds_->setToolTip("For the search of a tighter cage; 0: none.");
  form->addRow("Seconds for a tighter cage", seconds_);
  column->addLayout(form);
  text_ = new QPlainTextEdit(this);
  text_->setObjectName("validation_text");
  text_->setReadOnly(true);
  column->addWidget(text_);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  start_ = buttons->addButton("&Start", QDialogButtonBox::ActionRole);
  start_->setObjectName("validation_start");
  show_ = buttons->addButton("Show &Page", QDialogButtonBox::ActionRole);
  show_->setEnabled(false);
  column->addWidget(buttons);
  connect(start_, &QPushButton::clicked, this,
          [this] { process_.state() == QProcess::NotRunning ? start() : process_.terminate(); });
  connect(show_, &QPushButton::clicked, this, [this] { QDesktopServices::openUrl(QUrl::fromLocalFile(page())); });
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  process_.setProcessChannelMode(QProcess::MergedChannels);
  connect(&process_, &QProcess::readyRead, this, [this] {
    const QString all = QString::fromUtf8(process_.readAll());
    for (const QString& line : all.split(QRegExp("[\r\n]"), Qt::SkipEmptyParts)) text_->appendPlainText(line);
  });
  connect(&process_, QOverload<int, QProcess::ExitStatus>::of(&QProcess::finished), this,
          [this](int code, QProcess::ExitStatus status) { finish(code, status); });
  connect(&process_, &QProcess::errorOccurred, this, [this](QProcess::ProcessError error) {
    if (error != QProcess::FailedToStart) return;
    text_->appendPlainText("The program cannot be started: " + process_.program());
    start_->setText("&Start");
  });
}

ValidationDialog::~ValidationDialog() {
  process_.disconnect(this);
  process_.terminate();
  if (process_.state() != QProcess::NotRunning && !process_.waitForFinished(wait_ms)) process_.kill();
}

void ValidationDialog::start() {
  if (!editor_.workspace().plugin() || !editor_.workspace().has_scene())
    return text_->setPlainText("There is no scene, or no plug-in, to validate.");
  const QString scene = folder_.filePath("scene.glb");
  if (!editor_.attempt([&] { editor_.workspace().save_copy(scene.toStdString()); })) return;
  text_->clear();
  show_->setEnabled(false);
  start_->setText("&Stop");
  QStringList arguments = {"validate", scene, "--html", page(), "--seconds", QString::number(seconds_->value())};
  if (const auto& plugin = editor_.workspace().plugin())
    arguments << "--plugin" << QString::fromStdString(plugin->path().string());
  for (const Parameter& parameter : editor_.workspace().plugin()->parameters())
    if (const double value = editor_.workspace().parameter(parameter.id); value != parameter.default_value)
      arguments << "--set" << QString("%1=%2").arg(QString::fromStdString(parameter.id)).arg(value, 0, 'g', 17);
  process_.start(QCoreApplication::applicationDirPath() + "/cagewright", arguments);
}

void ValidationDialog::finish(int exit_code, QProcess::ExitStatus status) {
  start_->setText("&Start");
  show_->setEnabled(QFile::exists(page()));
  text_->appendPlainText(status == QProcess::CrashExit ? QString("Stopped.")
                         : exit_code == 0              ? QString("Done: Ceres agrees.")
                                                       : QString("Done, exit code %1.").arg(exit_code));
}

}  // namespace cagewright::host
