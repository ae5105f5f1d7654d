// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_APP_PLUGIN_MANAGER_H
#define CAGEWRIGHT_HOST_APP_PLUGIN_MANAGER_H

#include <QDialog>

#include "host/app/editor.h"

class QLabel;
class QPushButton;

namespace cagewright::host {

// Which plug-in is loaded, from where, its version and ABI; loads another one and unloads it.
class PluginManager : public QDialog {
 public:
  PluginManager(Editor& editor, QWidget* parent);

 private:
  void show_plugin();
  void choose();
  void run(const nlohmann::json& command, const QString& failure);

  Editor& editor_;
  QLabel* text_;
  QPushButton* unload_;
};

}  // namespace cagewright::host

#endif
