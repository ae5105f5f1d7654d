// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_APP_REPORT_PANEL_H
#define CAGEWRIGHT_HOST_APP_REPORT_PANEL_H

#include <QWidget>

#include "host/app/editor.h"

class QLabel;

namespace cagewright::host {

class ConvergencePlot;

// Certificate, measures, timings and convergence of the cage, as it changes.
class ReportPanel : public QWidget {
 public:
  ReportPanel(Editor& editor, QWidget* parent);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void show_verdict();
  void show_cage();

  Editor& editor_;
  QLabel *verdict_, *figures_;
  ConvergencePlot* plot_;
};

}  // namespace cagewright::host

#endif
