// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_APP_FILE_DIALOG_H
#define CAGEWRIGHT_HOST_APP_FILE_DIALOG_H

#include <QString>

class QWidget;

namespace cagewright::host {

// As QFileDialog::getOpenFileName and getSaveFileName; but a path that is typed whole and leads into the folder that is
// shown is taken, too: Qt's own dialog sometimes takes the folder instead. Empty: given up.
QString ask_for_file_to_open(QWidget* parent, const QString& title, const QString& folder, const QString& filters);
// Has asked before a file of that name is replaced. `filter` becomes the chosen one.
QString ask_for_file_to_save(QWidget* parent, const QString& title, const QString& suggested, const QString& filters,
                             QString& filter);

}  // namespace cagewright::host

#endif
