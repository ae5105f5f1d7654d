// SPDX-License-Identifier: BSD-3-Clause
#include "host/app/view_widget.h"

#include <vtkAxesActor.h>
#include <vtkOrientationMarkerWidget.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>

#include <QAction>
#include <QCursor>
#include <QGuiApplication>
#include <QKeyEvent>
#include <QLabel>
#include <QMouseEvent>
#include <QTimer>
#include <QWheelEvent>
#include <algorithm>
#include <nlohmann/json.hpp>

namespace cagewright::host {
namespace {

constexpr double wheel_notch = 120;  // of QWheelEvent's angle
constexpr int help_width = 640, help_margin = 16;
constexpr int longest_wait_ms = 50;  // of a frame, for its cage
constexpr int speed_ms = 400;        // between texts that tell the speed: they take time themselves

CameraControl::Axis axis_of(const std::string& name) {
  using Axis = CameraControl::Axis;
  if (name == "front") return Axis::front;
  if (name == "back") return Axis::back;
  if (name == "left") return Axis::left;
  if (name == "right") return Axis::right;
  if (name == "top") return Axis::top;
  if (name == "bottom") return Axis::bottom;
  return Axis::perspective;
}

}  // namespace

ViewWidget::ViewWidget(Editor& editor, Graphics graphics, QWidget* parent)
    : QWidget(parent), editor_(editor), canvas_(make_canvas(graphics, *this)) {
  setObjectName("view");
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setAccessibleName("3-D view");
  set_up_window();
  scene_ = std::make_unique<SceneView>(*renderer_);
  camera_ = std::make_unique<CameraControl>(*renderer_);
  handles_ = std::make_unique<SlideHandles>(*renderer_, *scene_);
  sync_ = std::make_unique<ViewSync>(editor_.workspace(), *scene_, *handles_);
  stroke_tool_ = std::make_unique<StrokeTool>(editor_, *scene_);
  select_tool_ = std::make_unique<SelectTool>(editor_, *scene_, *handles_);
  tool_ = select_tool_.get();
  help_ = new QLabel(this);
  help_->setObjectName("help");
  help_->setWordWrap(true);
  help_->setAttribute(Qt::WA_TransparentForMouseEvents);
  help_->setStyleSheet("background: rgba(20, 22, 26, 215); color: #f0f0f2; border-radius: 6px; padding: 12px;");
  help_->hide();
  late_frame_.setSingleShot(true);
  late_frame_.setInterval(longest_wait_ms);
  connect(&late_frame_, &QTimer::timeout, this, [this] { render_soon(); });
  speed_timer_.setSingleShot(true);
  speed_timer_.setInterval(speed_ms);
  connect(&speed_timer_, &QTimer::timeout, this, [this] { show_speed(); });
  speed_label_ = new QLabel(this);
  speed_label_->setObjectName("speed");
  speed_label_->setAttribute(Qt::WA_TransparentForMouseEvents);
  speed_label_->setStyleSheet("background: rgba(20, 22, 26, 215); color: #f0f0f2; padding: 4px;");
  speed_label_->hide();
  editor_.listen([this](WorkspaceChange change) { update(change); });
}

ViewWidget::~ViewWidget() = default;

void ViewWidget::set_up_window() {
  vtkRenderWindow& window = canvas_->window();
  window.AddRenderer(renderer_);
  // The mouse is ours: VTK's interactor is there for the axes in the corner alone.
  window.GetInteractor()->SetInteractorStyle(nullptr);
  axes_ = vtkSmartPointer<vtkOrientationMarkerWidget>::New();
  axes_->SetOrientationMarker(vtkNew<vtkAxesActor>());
  axes_->SetInteractor(window.GetInteractor());
  axes_->SetViewport(0, 0, 0.14, 0.2);
  axes_->SetEnabled(1);
  axes_->InteractiveOff();
}

void ViewWidget::update(WorkspaceChange change) {
  const bool is_drag_over = change == WorkspaceChange::slides && handles_->is_dragging() &&
                            editor_.workspace().preview().empty();  // a command has come in between
  if (change == WorkspaceChange::scene || change == WorkspaceChange::mesh || is_drag_over) cancel_tool();
  sync_->update(change);
  if (change == WorkspaceChange::cage && doing_ == Doing::tool)
    QMetaObject::invokeMethod(
        this, [this] { drag_to_cursor(); }, Qt::QueuedConnection);
  if (change == WorkspaceChange::scene) frame_all();
  const bool is_shown = change != WorkspaceChange::progress && change != WorkspaceChange::parameters &&
                        change != WorkspaceChange::saved && change != WorkspaceChange::plugin;
  if (is_shown) is_waiting_for_cage() ? render_with_cage() : render_soon();
  if (hint_changed_ && change != WorkspaceChange::progress) hint_changed_();
}

bool ViewWidget::is_waiting_for_cage() const {
  const Workspace& workspace = editor_.workspace();
  return doing_ == Doing::tool && !workspace.preview().empty() && workspace.progress().is_solving &&
         workspace.cage().asked == drawn_;
}

// Slide and cage move together, in one frame, unless the cage takes too long.
void ViewWidget::render_with_cage() {
  if (!late_frame_.isActive()) late_frame_.start();
}

// Once for all that changes until the event loop comes round.
void ViewWidget::render_soon() {
  late_frame_.stop();
  if (render_is_due_) return;
  render_is_due_ = true;
  QTimer::singleShot(0, this, [this] {
    render_is_due_ = false;
    render();
  });
}

void ViewWidget::render() {
  const auto begin = SpeedMeter::Clock::now();
  camera_->update_clipping();
  handles_->update();
  canvas_->draw();
  const CageState& cage = editor_.workspace().cage();
  drawn_ = cage.asked;
  if (doing_ != Doing::tool || !cage.is_of_editing || cage.failed) return;
  const auto end = SpeedMeter::Clock::now();
  speed_.add(cage.asked, end, end - begin);
  if (!speed_timer_.isActive()) speed_timer_.start();
}

// Before the frame is drawn, which takes time: the next cage can be made meanwhile, and the mouse's own event would
// come only after it.
void ViewWidget::drag_to_cursor() {
  const QPointF at = mapFromGlobal(QCursor::pos());
  if (!handles_->is_dragging() || at == last_) return;
  last_ = at;
  editor_.attempt([&] { tool_->drag(mouse_point(at, QGuiApplication::keyboardModifiers())); });
}

void ViewWidget::show_speed() {
  if (!speed_label_->isVisible()) return;
  speed_label_->setText(QString::fromStdString(speed_text(speed_.figures())));
  speed_label_->adjustSize();
  speed_label_->move(width() - speed_label_->width() - 8, height() - speed_label_->height() - 8);
}

void ViewWidget::use_select_tool(SlideHandles::Mode mode) {
  tool_->cancel();
  tool_ = select_tool_.get();
  handle_mode_ = mode;
  handles_->set_mode(mode);
  sync_->show_handles();
  unsetCursor();
  render_soon();
  if (hint_changed_) hint_changed_();
}

void ViewWidget::use_stroke_tool() {
  tool_->cancel();
  tool_ = stroke_tool_.get();
  handles_->set_mode(SlideHandles::Mode::none);
  setCursor(Qt::CrossCursor);
  render_soon();
  if (hint_changed_) hint_changed_();
}

bool ViewWidget::cancel_tool() {
  const bool was_held = doing_ == Doing::tool || doing_ == Doing::given_up;
  const bool was_busy = tool_->cancel() || was_held;
  const bool is_held = was_held && QGuiApplication::mouseButtons().testFlag(Qt::LeftButton);
  doing_ = is_held ? Doing::given_up : Doing::nothing;
  render_soon();
  return was_busy;
}

void ViewWidget::run(const nlohmann::json& command) {
  const std::string name = command.at("command");
  if (name == "frame") {
    const std::string what = command.value("what", "all");
    if (command.contains("slide"))
      frame_slide(command["slide"]);
    else
      what == "all" ? frame_all() : what == "model" ? frame_model() : frame_selection();
  } else if (name == "look") {
    camera_->look_along(axis_of(command.value("axis", "perspective")));
    frame_all();
  } else if (name == "up") {
    set_z_up(command.value("axis", "y") == "z");
  } else if (name == "projection") {
    camera_->set_orthographic(command.value("orthographic", false));
  } else if (name == "colours") {
    ViewOptions options = scene_->options();
    const std::string colours = command.value("by", "plain");
    options.colours = colours == "parts"      ? ViewOptions::Colours::parts
                      : colours == "coverage" ? ViewOptions::Colours::coverage
                                              : ViewOptions::Colours::plain;
    scene_->set_options(options);
  } else if (name == "show") {
    ViewOptions options = scene_->options();
    const std::string what = command.value("what", "");
    const bool on = command.value("on", true);
    if (what == "speed") {
      speed_label_->setVisible(on);
      show_speed();
    }
    if (what == "model") options.model = on;
    if (what == "other_meshes") options.other_meshes = on;
    if (what == "slides") options.slides = on;
    if (what == "sections") options.sections = on;
    if (what == "cage") options.cage = on;
    if (what == "cage_faces") options.cage_faces = on;
    if (what == "grid") options.grid = on;
    if (what == "wireframe") options.wireframe = on;
    scene_->set_options(options);
  }
  render_soon();
  if (look_changed_) look_changed_();
}

Point3 ViewWidget::up() const { return scene_->options().z_up ? Point3{0, 0, 1} : Point3{0, 1, 0}; }

bool ViewWidget::shows_speed() const { return speed_label_->isVisibleTo(this); }

void ViewWidget::frame_all() {
  if (const auto bounds = scene_->bounds()) camera_->frame(*bounds);
  render_soon();
}

void ViewWidget::frame_model() {
  if (const auto bounds = scene_->bounds_of_model()) camera_->frame(*bounds);
  render_soon();
}

void ViewWidget::frame_selection() { frame_slides(editor_.workspace().selection()); }

void ViewWidget::frame_slide(const std::string& name) {
  if (const SceneSlide* slide = editor_.workspace().find_slide(name)) frame_slides({slide->id});
}

void ViewWidget::frame_slides(const std::vector<std::int64_t>& ids) {
  const auto bounds = scene_->bounds_of_slides(ids);
  if (!bounds) return frame_all();
  camera_->frame(*bounds);
  render_soon();
}

void ViewWidget::frame_problem(const std::vector<std::int64_t>& slides, const std::optional<Point3>& place) {
  std::optional<std::array<double, 6>> bounds = scene_->bounds_of_slides(slides);
  if (const auto round = place ? scene_->bounds_of_place(*place) : std::nullopt) {
    if (!bounds) bounds = round;
    for (std::size_t i = 0; i < 6; ++i)
      (*bounds)[i] = i % 2 == 0 ? std::min((*bounds)[i], (*round)[i]) : std::max((*bounds)[i], (*round)[i]);
  }
  if (const auto toward_viewer = place ? scene_->direction_to_see(*place) : std::nullopt)
    camera_->look_from(*toward_viewer);
  if (bounds) camera_->frame(*bounds);
  render_soon();
}

void ViewWidget::mark_place(const std::optional<Point3>& place) {
  scene_->set_place(place);
  render_soon();
}

void ViewWidget::set_dark(bool dark) {
  ViewOptions options = scene_->options();
  options.dark = dark;
  scene_->set_options(options);
  render_soon();
}

void ViewWidget::set_z_up(bool z_up) {
  ViewOptions options = scene_->options();
  options.z_up = z_up;
  scene_->set_options(options);
  camera_->set_up(up());
  frame_all();
}

void ViewWidget::show_help(const QString& text) {
  if (help_->text() == text) return;
  help_->setText(text);
  help_->setVisible(!text.isEmpty());
  place_help();
}

void ViewWidget::place_help() {
  help_->setFixedWidth(std::min(help_width, std::max(120, width() - 2 * help_margin)));
  help_->adjustSize();
  // Below the model, beside the axes.
  help_->move(width() - help_->width() - help_margin, height() - help_->height() - help_margin);
}

MousePoint ViewWidget::mouse_point(const QPointF& position, Qt::KeyboardModifiers modifiers) const {
  const double ratio = devicePixelRatioF();
  return {position.x() * ratio, (height() - 1 - position.y()) * ratio, modifiers.testFlag(Qt::ShiftModifier),
          modifiers.testFlag(Qt::ControlModifier)};
}

QPoint ViewWidget::screen_position(const Point3& point) const {
  const auto [x, y] = scene_->to_display(point);
  const double ratio = devicePixelRatioF();
  return mapToGlobal(QPoint(qRound(x / ratio), qRound(height() - 1 - y / ratio)));
}

ViewWidget::Doing ViewWidget::begin_of(const QMouseEvent& event) {
  const bool alt = event.modifiers().testFlag(Qt::AltModifier);
  switch (event.button()) {
    case Qt::LeftButton:
      if (alt) return Doing::tumble;
      return tool_->press(mouse_point(event.localPos(), event.modifiers())) ? Doing::tool : Doing::tumble;
    case Qt::MiddleButton:
      return Doing::track;
    case Qt::RightButton:
      return alt ? Doing::dolly : Doing::tumble;
    default:
      return Doing::nothing;
  }
}

// A key that is accepted here is no shortcut, not even of an action that is disabled: it comes as a key of the view.
bool ViewWidget::event(QEvent* event) {
  const bool is_held = doing_ == Doing::tool || doing_ == Doing::given_up;
  if (!is_held || (event->type() != QEvent::ShortcutOverride && event->type() != QEvent::KeyPress))
    return QWidget::event(event);
  event->accept();
  const auto* key = static_cast<const QKeyEvent*>(event);
  const QKeySequence keys(static_cast<int>(key->modifiers()) | key->key());
  const auto has_keys = [&](const QAction* action) { return action->shortcuts().contains(keys); };
  if (event->type() == QEvent::KeyPress && std::ranges::any_of(cancels_drag_, has_keys)) cancel_tool();
  return true;
}

void ViewWidget::mousePressEvent(QMouseEvent* event) {
  if (doing_ != Doing::nothing && doing_ != Doing::given_up) return;  // a second button while one is down
  last_ = event->localPos();
  doing_ = begin_of(*event);
  if (doing_ == Doing::tool) speed_.begin(drawn_);
  render_soon();
  if (hint_changed_) hint_changed_();
}

void ViewWidget::mouseMoveEvent(QMouseEvent* event) {
  // A dialog has taken the release.
  if (doing_ != Doing::nothing && event->buttons() == Qt::NoButton) cancel_tool();
  const QPointF by = (event->localPos() - last_) * devicePixelRatioF();
  const MousePoint at = mouse_point(event->localPos(), event->modifiers());
  switch (doing_) {
    case Doing::nothing:
      if (tool_->hover(at)) render_soon();
      last_ = event->localPos();
      return;
    case Doing::tool:
      editor_.attempt([&] { tool_->drag(at); });
      break;
    case Doing::given_up:
      break;
    case Doing::tumble:
      camera_->tumble(by.x(), -by.y());
      break;
    case Doing::track:
      camera_->track(by.x(), -by.y());
      break;
    case Doing::dolly:
      camera_->dolly(by.x() - by.y());
      break;
  }
  last_ = event->localPos();
  is_waiting_for_cage() ? render_with_cage() : render_soon();
}

void ViewWidget::mouseReleaseEvent(QMouseEvent* event) {
  if (event->buttons() != Qt::NoButton) return;
  if (std::exchange(doing_, Doing::nothing) == Doing::tool)
    editor_.attempt([&] { tool_->release(mouse_point(event->localPos(), event->modifiers())); });
  render_soon();
  if (hint_changed_) hint_changed_();
}

void ViewWidget::mouseDoubleClickEvent(QMouseEvent* event) { mousePressEvent(event); }

void ViewWidget::wheelEvent(QWheelEvent* event) {
  const MousePoint at = mouse_point(event->position(), event->modifiers());
  camera_->zoom_at(event->angleDelta().y() / wheel_notch, at.x, at.y);
  render_soon();
}

void ViewWidget::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  canvas_->widget().setGeometry(rect());
  render_soon();
  place_help();
  show_speed();
}

}  // namespace cagewright::host
