// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_APP_FILE_ENDING_H
#define CAGEWRIGHT_HOST_APP_FILE_ENDING_H

#include <QString>

namespace cagewright::host {

// `file`, where it has no ending with the first of a file dialog's filter: "Meshes (*.obj *.off)" has ".obj".
QString with_ending_of(const QString& filter, const QString& file);

}  // namespace cagewright::host

#endif
