// SPDX-License-Identifier: BSD-3-Clause
#include "host/app/theme.h"

#include <QApplication>
#include <QColor>
#include <QPalette>
#include <QStyle>
#include <QStyleFactory>

namespace cagewright::host {
namespace {

QPalette dark_palette() {
  const QColor window(0x2f, 0x30, 0x33), base(0x24, 0x25, 0x28), text(0xe2, 0xe2, 0xe4), dim(0x86, 0x87, 0x8c);
  QPalette palette;
  palette.setColor(QPalette::Window, window);
  palette.setColor(QPalette::WindowText, text);
  palette.setColor(QPalette::Base, base);
  palette.setColor(QPalette::AlternateBase, QColor(0x2a, 0x2b, 0x2e));
  palette.setColor(QPalette::ToolTipBase, QColor(0x45, 0x46, 0x4b));
  palette.setColor(QPalette::ToolTipText, text);
  palette.setColor(QPalette::PlaceholderText, dim);
  palette.setColor(QPalette::Text, text);
  palette.setColor(QPalette::Button, QColor(0x3b, 0x3c, 0x40));
  palette.setColor(QPalette::ButtonText, text);
  palette.setColor(QPalette::BrightText, QColor(0xff, 0x6b, 0x5e));
  palette.setColor(QPalette::Link, QColor(0x6a, 0xb0, 0xff));
  palette.setColor(QPalette::Highlight, QColor(0x2f, 0x6f, 0xb5));
  palette.setColor(QPalette::HighlightedText, Qt::white);
  for (const QPalette::ColorRole role : {QPalette::Text, QPalette::WindowText, QPalette::ButtonText})
    palette.setColor(QPalette::Disabled, role, dim);
  palette.setColor(QPalette::Disabled, QPalette::Light, window);  // no etched shadow
  return palette;
}

}  // namespace

QColor colour_of(Tone tone, const QPalette& palette) {
  const bool is_dark = palette.color(QPalette::Window).lightness() < 128;
  switch (tone) {
    case Tone::good:
      return is_dark ? QColor(0x5f, 0xbf, 0x77) : QColor(0x14, 0x6c, 0x2e);
    case Tone::doubtful:
      return is_dark ? QColor(0xff, 0x9f, 0x43) : QColor(0x8f, 0x4a, 0x00);
    case Tone::bad:
      return is_dark ? QColor(0xff, 0x8a, 0x7d) : QColor(0xb3, 0x1b, 0x12);
    case Tone::unknown:
      break;
  }
  return is_dark ? QColor(0x9a, 0x9a, 0xa0) : QColor(0x5a, 0x5b, 0x60);
}

void apply_theme(QApplication& application, bool dark) {
  application.setStyle(QStyleFactory::create("Fusion"));
  application.setPalette(dark ? dark_palette() : application.style()->standardPalette());
}

}  // namespace cagewright::host
