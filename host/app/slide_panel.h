// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_APP_SLIDE_PANEL_H
#define CAGEWRIGHT_HOST_APP_SLIDE_PANEL_H

#include <QWidget>
#include <array>

#include "host/app/editor.h"
#include "host/app/slide_placement.h"

class QFormLayout;
class QLabel;

namespace cagewright::host {

class FieldEdit;
class NumberField;

// The slide that was selected last, in numbers; each edit is one step of undo.
class SlidePanel : public QWidget {
 public:
  SlidePanel(Editor& editor, QWidget* parent);

 private:
  void add_numbers(QFormLayout& form, const QString& label, const QString& name, const QString& tip,
                   NumberField** first, int count);
  const SceneSlide* slide() const;
  void show_slide();
  void rename();
  void take_numbers();

  Editor& editor_;
  FieldEdit* name_;
  std::array<NumberField*, 3> translate_{}, rotate_{};
  std::array<NumberField*, 2> radii_{};
  QLabel* state_;
};

}  // namespace cagewright::host

#endif
