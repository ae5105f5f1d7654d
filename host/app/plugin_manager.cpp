// SPDX-License-Identifier: BSD-3-Clause
#include "host/app/plugin_manager.h"

#include <QDialogButtonBox>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QVBoxLayout>
#include <exception>

#include "host/app/file_dialog.h"

namespace cagewright::host {

PluginManager::PluginManager(Editor& editor, QWidget* parent) : QDialog(parent), editor_(editor) {
  setObjectName("plugin_manager");
  setWindowTitle("Plug-ins");
  setMinimumWidth(520);
  auto* column = new QVBoxLayout(this);
  text_ = new QLabel(this);
  text_->setObjectName("plugin_text");
  text_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  text_->setWordWrap(true);
  column->addWidget(text_);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  QPushButton* load = buttons->addButton("&Load ...", QDialogButtonBox::ActionRole);
  load->setObjectName("load_plugin");
  load->setToolTip("Another file in place of this one: the cage is then made by that.");
  unload_ = buttons->addButton("&Unload", QDialogButtonBox::ActionRole);
  unload_->setObjectName("unload_plugin");
  unload_->setToolTip("Refused while the scene uses it: close the scene first.");
  column->addWidget(buttons);
  connect(load, &QPushButton::clicked, this, [this] { choose(); });
  connect(unload_, &QPushButton::clicked, this, [this] { run({{"command", "unload_plugin"}}, "Not unloaded"); });
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  editor_.listen([this](WorkspaceChange change) {
    if (change == WorkspaceChange::plugin) show_plugin();
  });
  show_plugin();
}

void PluginManager::show_plugin() {
  const std::shared_ptr<const Plugin>& plugin = editor_.workspace().plugin();
  unload_->setEnabled(plugin != nullptr);
  if (!plugin) {
    text_->setText(
        "No plug-in is loaded. Scenes can be opened and saved, with the slides and cages that they hold; "
        "nothing can be fitted or caged.");
    return;
  }
  text_->setText(
      QString("<table><tr><td>File&nbsp;&nbsp;</td><td>%1</td></tr><tr><td>Version</td><td>%2</td></tr>"
              "<tr><td>ABI</td><td>%3.%4</td></tr><tr><td>Parameters&nbsp;&nbsp;</td><td>%5</td></tr></table>")
          .arg(QString::fromStdString(plugin->path().string()).toHtmlEscaped(),
               QString::fromStdString(plugin->version()).toHtmlEscaped())
          .arg(plugin->api().abi_major)
          .arg(plugin->api().abi_minor)
          .arg(plugin->api().parameter_count));
}

void PluginManager::choose() {
  const QString file = ask_for_file_to_open(this, "Load a plug-in", "", "Plug-ins (*.so);;All files (*)");
  if (!file.isEmpty()) run({{"command", "load_plugin"}, {"path", file.toStdString()}}, "Not loaded");
}

// A failure gets a box: the line at the bottom of the window is away from here.
void PluginManager::run(const nlohmann::json& command, const QString& failure) {
  try {
    editor_.run_or_throw(command);
  } catch (const std::exception& error) {
    QMessageBox::warning(this, failure, QString::fromStdString(error.what()));
  }
}

}  // namespace cagewright::host
