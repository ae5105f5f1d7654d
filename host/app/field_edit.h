// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_APP_FIELD_EDIT_H
#define CAGEWRIGHT_HOST_APP_FIELD_EDIT_H

#include <QLineEdit>
#include <functional>

namespace cagewright::host {

// A line that is typed and then taken. Undo and redo are the window's but while something is typed that was not taken
// yet (isModified()); Escape gives that up.
class FieldEdit : public QLineEdit {
 public:
  using QLineEdit::QLineEdit;
  void on_give_up(std::function<void()> show_value) { show_value_ = std::move(show_value); }

 protected:
  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  std::function<void()> show_value_;
};

}  // namespace cagewright::host

#endif
