// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_APP_NUMBER_FIELD_H
#define CAGEWRIGHT_HOST_APP_NUMBER_FIELD_H

#include <functional>
#include <limits>
#include <string>

#include "host/app/field_edit.h"

namespace cagewright::host {

// A number of any size, shown with as many digits as there is room for, its exponent always; a spin box would cut 1e-9
// to 0. The tool tip has all digits. Told when return or tabulator ends the editing; whoever is told sees to the range
// and shows the number before again where it refuses. What is no number is refused here, and goes back to what it was.
// The arrow keys change the second digit, within the range.
class NumberField : public FieldEdit {
 public:
  explicit NumberField(QWidget* parent = nullptr);

  void set_range(double least, double greatest, bool is_integer);  // of the arrow keys
  void set_value(double value);                                    // tells nobody
  void show(double value);                                         // the same, but not while another number is typed
  double value() const { return value_; }
  void on_edit(std::function<void(double)> edited) { edited_ = std::move(edited); }
  void on_refusal(std::function<void(const std::string& sentence)> tell) { refused_ = std::move(tell); }

 protected:
  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  QString fitting_text() const;
  void refuse(const QString& typed);
  void finish();
  void step(int steps);

  double value_ = 0;
  double least_ = -std::numeric_limits<double>::infinity(), greatest_ = std::numeric_limits<double>::infinity();
  bool is_integer_ = false;
  std::function<void(double)> edited_;
  std::function<void(const std::string&)> refused_;
};

}  // namespace cagewright::host

#endif
