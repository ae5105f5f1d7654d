// SPDX-License-Identifier: BSD-3-Clause
#include "host/app/field_edit.h"

#include <QKeyEvent>

namespace cagewright::host {

bool FieldEdit::event(QEvent* event) {
  if (event->type() != QEvent::ShortcutOverride) return QLineEdit::event(event);
  auto* key = static_cast<QKeyEvent*>(event);
  if (key->key() == Qt::Key_Escape && isModified()) {
    event->accept();
    return true;
  }
  if (!isModified() && (key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo))) {
    event->ignore();
    return true;
  }
  return QLineEdit::event(event);
}

void FieldEdit::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape && isModified()) {
    setModified(false);
    if (show_value_) show_value_();
  }
  QLineEdit::keyPressEvent(event);
}

}  // namespace cagewright::host
