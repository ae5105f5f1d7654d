// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_APP_THEME_H
#define CAGEWRIGHT_HOST_APP_THEME_H

#include <QColor>

class QApplication;
class QPalette;

namespace cagewright::host {

// What a text says, for its colour, which can be read on the palette's windows.
enum class Tone { good, doubtful, bad, unknown };
QColor colour_of(Tone tone, const QPalette& palette);

// Fusion in dark or light colours, the same on every desktop.
void apply_theme(QApplication& application, bool dark);

}  // namespace cagewright::host

#endif
