// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_APP_THEME_H
#define CAGEWRIGHT_HOST_APP_THEME_H

class QApplication;

namespace cagewright::host {

// Fusion in dark or light colours, the same on every desktop.
void apply_theme(QApplication& application, bool dark);

}  // namespace cagewright::host

#endif
