// SPDX-License-Identifier: BSD-3-Clause
#include "host/app/number_field.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QLocale>
#include <QStyle>
#include <QStyleOptionFrame>
#include <QToolTip>
#include <algorithm>
#include <cmath>

namespace cagewright::host {
namespace {

constexpr int most_digits = 5;  // shown; the value keeps all
constexpr int text_margin = 4;  // QLineEdit's, beside its text, and the cursor
constexpr char widest[] = "-8e-888";

}  // namespace

NumberField::NumberField(QWidget* parent) : FieldEdit(parent) {
  on_give_up([this] { set_value(value_); });
  setAlignment(Qt::AlignRight);
  setMinimumWidth(fontMetrics().horizontalAdvance(widest) + 4 * text_margin);
  connect(this, &QLineEdit::editingFinished, this, [this] { finish(); });
  set_value(0);
}

void NumberField::set_range(double least, double greatest, bool is_integer) {
  least_ = least;
  greatest_ = greatest;
  is_integer_ = is_integer;
}

void NumberField::set_value(double value) {
  value_ = value;
  setText(fitting_text());
  setModified(false);
  setCursorPosition(0);
}

QString NumberField::fitting_text() const {
  QStyleOptionFrame option;
  initStyleOption(&option);
  const int room = style()->subElementRect(QStyle::SE_LineEditContents, &option, this).width() - 2 * text_margin;
  QString text;
  for (int digits = most_digits; digits > 0; --digits) {
    const QString shorter = QLocale::c().toString(value_, 'g', digits);  // 12345 is longer with three: 1.23e+04
    const int width = fontMetrics().horizontalAdvance(shorter);
    if (text.isEmpty() || width < fontMetrics().horizontalAdvance(text)) text = shorter;
    if (width <= room) break;
  }
  return text;
}

void NumberField::resizeEvent(QResizeEvent* event) {
  QLineEdit::resizeEvent(event);
  if (!text().isEmpty() && !isModified()) set_value(value_);
}

void NumberField::show(double value) {
  // What is shown already stays as it is: somebody may have selected it to type over it.
  const bool is_shown = value == value_ && !isModified() && !text().isEmpty();
  if (!is_shown && !(isModified() && hasFocus())) set_value(value);
}

bool NumberField::event(QEvent* event) {
  if (event->type() == QEvent::ToolTip && !text().isEmpty()) {
    const QString value = QLocale::c().toString(value_, 'g', QLocale::FloatingPointShortest);
    QToolTip::showText(static_cast<QHelpEvent*>(event)->globalPos(), toolTip() + "\n" + value, this);
    return true;
  }
  return FieldEdit::event(event);
}

void NumberField::finish() {
  if (!isModified()) return;
  bool is_number = false;
  const QString typed = text().trimmed();
  const double value = QLocale::c().toDouble(QString(typed).replace(',', '.'), &is_number);
  if (!is_number || !std::isfinite(value)) return refuse(typed);
  if (value == value_) return set_value(value_);
  set_value(value);
  if (edited_) edited_(value);
}

void NumberField::refuse(const QString& typed) {
  set_value(value_);
  if (!refused_) return;
  const QString what = typed.isEmpty() ? QString("nothing was typed") : QString("\"%1\" is no number").arg(typed);
  refused_(QString("%1: %2, it stays %3").arg(accessibleName(), what, QLocale::c().toString(value_)).toStdString());
}

void NumberField::step(int steps) {
  finish();
  const double unit = is_integer_ ? 1 : std::pow(10, std::floor(std::log10(std::max(std::abs(value_), 1e-3))) - 1);
  const double value = std::clamp(value_ + steps * unit, least_, greatest_);
  if (value == value_) return;
  set_value(value);
  if (edited_) edited_(value);
}

void NumberField::keyPressEvent(QKeyEvent* event) {
  switch (event->key()) {
    case Qt::Key_Up:
      return step(1);
    case Qt::Key_Down:
      return step(-1);
    default:
      FieldEdit::keyPressEvent(event);
  }
}

}  // namespace cagewright::host
