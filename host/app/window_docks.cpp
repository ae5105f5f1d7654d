// SPDX-License-Identifier: BSD-3-Clause
// The panels round the view, and where they are in a window that is too small for all of them.
#include <QDockWidget>
#include <QScrollArea>
#include <QTabWidget>

#include "host/app/main_window.h"
#include "host/app/outliner.h"
#include "host/app/parameter_panel.h"
#include "host/app/problems_list.h"
#include "host/app/report_panel.h"
#include "host/app/slide_panel.h"
#include "host/app/view_widget.h"

namespace cagewright::host {
namespace {

constexpr int dock_width = 290;
// With panels on both sides; below, the view would have less than they.
constexpr QSize least_wide(4 * dock_width + 40, 600);

QWidget* scrolled(QWidget* content) {
  auto* area = new QScrollArea;
  area->setWidget(content);
  area->setWidgetResizable(true);
  area->setFrameShape(QFrame::NoFrame);
  return area;
}

}  // namespace

void MainWindow::make_docks() {
  const auto dock = [this](const QString& name, const QString& title, QWidget* content, Qt::DockWidgetArea area) {
    auto* widget = new QDockWidget(title, this);
    widget->setObjectName(name);
    widget->setWidget(content);
    addDockWidget(area, widget);
    return widget;
  };
  dock("outliner_dock", "Outliner", new Outliner(*editor_, this), Qt::LeftDockWidgetArea);
  problems_ = new ProblemsList(*editor_, this);
  QDockWidget* problems = dock("problems_dock", "Problems", problems_, Qt::LeftDockWidgetArea);
  problems_->on_count([problems](int count) {
    problems->setWindowTitle(count == 0 ? QString("Problems") : QString("Problems (%1)").arg(count));
  });
  problems_->on_frame([this](const Problem& problem) { view_->frame_problem(problem.slides, problem.place); });
  problems_->on_choose([this](const std::string& sentence) { show_parameter_of(sentence); });
  problems_->on_mark([this](const std::optional<Point3>& place) { view_->mark_place(place); });
  tabs_ = new QTabWidget(this);
  tabs_->setObjectName("tabs");
  tabs_->addTab(scrolled(new SlidePanel(*editor_, this)), "Slide");
  parameters_ = new ParameterPanel(*editor_, this);
  tabs_->addTab(scrolled(parameters_), "Cage");
  dock("attributes_dock", "Attributes", tabs_, Qt::RightDockWidgetArea);
  dock("report_dock", "Report", scrolled(new ReportPanel(*editor_, this)), Qt::RightDockWidgetArea);
  for (QDockWidget* widget : findChildren<QDockWidget*>()) widget->setMinimumWidth(dock_width);
  share_heights();
  resizeDocks({problems, findChild<QDockWidget*>("attributes_dock")}, {dock_width, dock_width}, Qt::Horizontal);
}

// The field of the parameter that a sentence advises to set.
void MainWindow::show_parameter_of(const std::string& sentence) {
  QWidget* field = parameters_->field_named_in(sentence);
  if (!field) return;
  auto* area = static_cast<QScrollArea*>(tabs_->widget(1));
  tabs_->setCurrentWidget(area);
  field->setFocus(Qt::OtherFocusReason);
  // Its place is known once the tab is laid out.
  QTimer::singleShot(0, field, [area, field] { area->ensureWidgetVisible(field); });
}

void MainWindow::share_heights() {
  resizeDocks({findChild<QDockWidget*>("outliner_dock"), findChild<QDockWidget*>("problems_dock")}, {1, 1},
              Qt::Vertical);
  resizeDocks({findChild<QDockWidget*>("attributes_dock"), findChild<QDockWidget*>("report_dock")}, {2, 3},
              Qt::Vertical);
}

void MainWindow::resizeEvent(QResizeEvent* event) {
  QMainWindow::resizeEvent(event);
  const bool is_narrow = width() < least_wide.width() || height() < least_wide.height();
  // Not within the event: it is of a layout that this changes.
  if (is_narrow != wide_docks_.has_value())
    QTimer::singleShot(0, this, [this] { set_narrow(width() < least_wide.width() || height() < least_wide.height()); });
}

void MainWindow::set_narrow(bool narrow) {
  if (narrow == wide_docks_.has_value()) return;
  if (!narrow) {
    restoreState(*wide_docks_);
    share_heights();  // those of the state are of the window when it had just become small
    wide_docks_.reset();
    return;
  }
  wide_docks_ = saveState();
  setTabPosition(Qt::LeftDockWidgetArea, QTabWidget::West);  // above one another: side by side they would be cut off
  QDockWidget* first = nullptr;
  for (const char* name : {"outliner_dock", "problems_dock", "attributes_dock", "report_dock"}) {
    auto* dock = findChild<QDockWidget*>(name);
    if (dock->isFloating() || dock->isHidden()) continue;
    addDockWidget(Qt::LeftDockWidgetArea, dock);
    if (first)
      tabifyDockWidget(first, dock);
    else
      first = dock;
  }
  if (!first) return;
  first->raise();
  resizeDocks({first}, {dock_width}, Qt::Horizontal);
}

}  // namespace cagewright::host
