// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_APP_PARAMETER_PANEL_H
#define CAGEWRIGHT_HOST_APP_PARAMETER_PANEL_H

#include <QWidget>
#include <functional>
#include <map>
#include <string>

#include "host/app/editor.h"

class QFormLayout;
class QVBoxLayout;

namespace cagewright::host {

// The cage's parameters as the plug-in lists them: labels, ranges, units and tool tips are its own.
class ParameterPanel : public QWidget {
 public:
  ParameterPanel(Editor& editor, QWidget* parent);

  // Of the parameter whose id a sentence has in it; null: none.
  QWidget* field_named_in(const std::string& sentence) const;

 private:
  void build();
  void add(const Parameter& parameter, QFormLayout& form);
  QWidget* make_field(const Parameter& parameter);
  void show_values();
  void set(const std::string& id, double value);

  Editor& editor_;
  QVBoxLayout* layout_;
  QWidget* fields_ = nullptr;
  std::map<std::string, std::function<void(double)>> show_;  // by id
};

}  // namespace cagewright::host

#endif
