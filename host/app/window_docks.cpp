// SPDX-License-Identifier: BSD-3-Clause
// The panels round the view, and where they are in a window that is too small for all of them.
#include <QCoreApplication>
#include <QDockWidget>
#include <QEvent>
#include <QHoverEvent>
#include <QRegularExpression>
#include <QScrollArea>
#include <QSettings>
#include <QTabWidget>
#include <utility>

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
constexpr char panel_names[] = "^(\\w+_dock|tool_bar)$";  // what can be hidden
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
  for (QDockWidget* widget : findChildren<QDockWidget*>()) {
    widget->setMinimumWidth(dock_width);
    widget->installEventFilter(this);
  }
  share_heights();
  resizeDocks({problems, findChild<QDockWidget*>("attributes_dock")}, {dock_width, dock_width}, Qt::Horizontal);
  first_docks_ = saveState();
}

// Though it was hidden, or behind others.
void MainWindow::show_panel(const QString& name) {
  auto* dock = findChild<QDockWidget*>(name);
  dock->show();
  is_narrow_ ? show_tab(dock) : dock->raise();
}

void MainWindow::rename_slide() {
  if (editor_->workspace().selection().empty()) return;
  show_panel("outliner_dock");
  findChild<Outliner*>()->edit_name(editor_->workspace().selection().back());
}

// The field of the parameter that a sentence advises to set.
void MainWindow::show_parameter_of(const std::string& sentence) {
  QWidget* field = parameters_->field_named_in(sentence);
  if (!field) return;
  show_panel("attributes_dock");
  auto* area = static_cast<QScrollArea*>(tabs_->widget(1));
  tabs_->setCurrentWidget(area);
  field->setFocus(Qt::TabFocusReason);  // with the frame that shows where it is
  // Its place is known once the tab is laid out.
  QTimer::singleShot(0, field, [area, field] { area->ensureWidgetVisible(field); });
}

void MainWindow::share_heights() {
  resizeDocks({findChild<QDockWidget*>("outliner_dock"), findChild<QDockWidget*>("problems_dock")}, {1, 1},
              Qt::Vertical);
  resizeDocks({findChild<QDockWidget*>("attributes_dock"), findChild<QDockWidget*>("report_dock")}, {2, 3},
              Qt::Vertical);
}

// Where panels are was noted before any was laid out: how high they are was not known then.
void MainWindow::share_first_heights() {
  if (std::exchange(was_never_wide_, false) || wide_docks_ == first_docks_) share_heights();
}

bool MainWindow::is_small() const { return width() < least_wide.width() || height() < least_wide.height(); }

void MainWindow::resizeEvent(QResizeEvent* event) {
  QMainWindow::resizeEvent(event);
  // Not within the event: it is of a layout that this changes.
  if (is_small() != is_narrow_) QTimer::singleShot(0, this, [this] { set_narrow(is_small()); });
}

// Of the panels. A window that becomes small presses them together before it is told: what they were is noted each time
// that one is laid out.
bool MainWindow::eventFilter(QObject* watched, QEvent* event) {
  auto* dock = qobject_cast<QDockWidget*>(watched);
  const QEvent::Type type = event->type();
  if (dock && type == QEvent::ShowToParent && is_narrow_) QTimer::singleShot(0, dock, [this, dock] { show_tab(dock); });
  if (dock && (type == QEvent::Resize || type == QEvent::Move))
    QTimer::singleShot(0, this, [this] {
      if (!is_narrow_ && !is_small() && isVisible()) wide_docks_ = saveState();
    });
  return QMainWindow::eventFilter(watched, event);
}

// Qt keeps which border between panels the pointer is on, and looks that up when the pointer leaves it, also where
// panels have moved meanwhile: it may not be there any more, which ends the program.
void MainWindow::forget_border() {
  QHoverEvent leave(QEvent::HoverLeave, QPointF(-1, -1), QPointF(-1, -1));
  QCoreApplication::sendEvent(this, &leave);
}

void MainWindow::set_narrow(bool narrow) {
  if (narrow == is_narrow_) return;
  forget_border();
  if (!narrow) {
    const QStringList shown = shown_panels();
    is_narrow_ = false;
    setTabPosition(Qt::LeftDockWidgetArea, QTabWidget::South);
    restoreState(wide_docks_);
    share_first_heights();
    show_panels(shown);
    return;
  }
  was_never_wide_ = wide_docks_.isEmpty();
  if (was_never_wide_) wide_docks_ = saveState();
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
  is_narrow_ = true;
  if (!first) return;
  first->raise();
  resizeDocks({first}, {dock_width}, Qt::Horizontal);
}

void MainWindow::show_tab(QDockWidget* dock) {
  if (!is_narrow_ || dock->isFloating() || dock->isHidden()) return;
  forget_border();
  addDockWidget(Qt::LeftDockWidgetArea, dock);
  for (QDockWidget* other : findChildren<QDockWidget*>())
    if (other != dock && !other->isFloating() && !other->isHidden()) {
      tabifyDockWidget(other, dock);
      break;
    }
  dock->raise();
  resizeDocks({dock}, {dock_width}, Qt::Horizontal);
}

QStringList MainWindow::shown_panels() const {
  QStringList shown;
  for (const QWidget* panel : findChildren<QWidget*>(QRegularExpression(panel_names)))
    if (!panel->isHidden()) shown.append(panel->objectName());
  return shown;
}

void MainWindow::show_panels(const QStringList& shown) {
  for (QWidget* panel : findChildren<QWidget*>(QRegularExpression(panel_names)))
    panel->setVisible(shown.contains(panel->objectName()));
}

void MainWindow::reset_panels() {
  forget_border();
  wide_docks_ = first_docks_;
  is_narrow_ = false;
  setTabPosition(Qt::LeftDockWidgetArea, QTabWidget::South);
  restoreState(first_docks_);
  for (QDockWidget* dock : findChildren<QDockWidget*>()) dock->show();
  share_heights();
  resizeDocks({findChild<QDockWidget*>("problems_dock"), findChild<QDockWidget*>("attributes_dock")},
              {dock_width, dock_width}, Qt::Horizontal);
  if (is_small()) set_narrow(true);
}

void MainWindow::save_layout() const {
  QSettings settings;
  settings.setValue("geometry", saveGeometry());
  if (!was_never_wide_) settings.setValue("docks", is_narrow_ ? wide_docks_ : saveState());
  settings.setValue("panels", shown_panels());
}

void MainWindow::restore_layout() {
  const QSettings settings;
  restoreGeometry(settings.value("geometry").toByteArray());
  const QByteArray docks = settings.value("docks").toByteArray();
  if (restoreState(docks)) {
    wide_docks_ = docks;
    share_first_heights();
  }
  if (settings.contains("panels")) show_panels(settings.value("panels").toStringList());
}

}  // namespace cagewright::host
