// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_APP_VIEW_WIDGET_H
#define CAGEWRIGHT_HOST_APP_VIEW_WIDGET_H

#include <vtkNew.h>
#include <vtkSmartPointer.h>
#include <QTimer>
#include <QWidget>

#include <functional>
#include <nlohmann/json_fwd.hpp>

#include "host/app/canvas.h"
#include "host/app/editor.h"
#include "host/app/select_tool.h"
#include "host/app/speed_meter.h"
#include "host/app/stroke_tool.h"
#include "host/app/view_sync.h"
#include "host/view/window/camera_control.h"
#include "host/view/window/scene_view.h"
#include "host/view/window/slide_handles.h"

class QAction;
class QLabel;
class vtkOrientationMarkerWidget;
class vtkRenderer;

namespace cagewright::host {

// The 3-D view: mouse and keys as Maya has them. Alt + left, middle, right: tumble, track, dolly; without alt, middle
// tracks, right tumbles, the wheel goes nearer, and left is the tool's, which leaves to tumbling what is not for it.
class ViewWidget : public QWidget {
 public:
  ViewWidget(Editor& editor, Graphics graphics, QWidget* parent);
  ~ViewWidget() override;

  SceneView& scene() { return *scene_; }
  CameraControl& camera() { return *camera_; }
  SlideHandles& handles() { return *handles_; }
  StrokeTool& stroke_tool() { return *stroke_tool_; }

  void use_select_tool(SlideHandles::Mode mode);
  void use_stroke_tool();
  bool is_drawing() const { return tool_ == stroke_tool_.get(); }
  QString hint() const { return tool_->hint(); }
  void on_hint(std::function<void()> changed) { hint_changed_ = std::move(changed); }
  void on_look(std::function<void()> changed) { look_changed_ = std::move(changed); }  // by a command of run()
  Point3 up() const;
  bool shows_speed() const;
  bool cancel_tool();  // false: there was nothing to give up
  // While the tool's button is held, the keys of these actions give the drag up, and no other key is heard: the drag is
  // all that may change.
  void cancel_drag_by(std::vector<const QAction*> actions) { cancels_drag_ = std::move(actions); }

  // The commands of ScriptRunner that are the view's: frame, look, up, projection, show, colours.
  void run(const nlohmann::json& command);
  void frame_all();
  void frame_model();  // the one that is being caged
  void frame_selection();
  void frame_slide(const std::string& name);
  // Slides and place together; what is not there is not framed. Where the model hides the place the camera is turned.
  void frame_problem(const std::vector<std::int64_t>& slides, const std::optional<Point3>& place);
  void mark_place(const std::optional<Point3>& place);  // empty: no mark
  void show_help(const QString& text);                  // over the view; empty: none
  const SpeedMeter& speed() const { return speed_; }    // of the drag, or the last one

  void render_soon();
  void set_dark(bool dark);
  // A point of the active mesh as a global screen position, for tests.
  QPoint screen_position(const Point3& point) const;

 protected:
  bool event(QEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  enum class Doing { nothing, tool, given_up, tumble, track, dolly };  // given_up: the tool's button is held still

  void set_up_window();
  void frame_slides(const std::vector<std::int64_t>& ids);
  void update(WorkspaceChange change);
  MousePoint mouse_point(const QPointF& position, Qt::KeyboardModifiers modifiers) const;
  Doing begin_of(const QMouseEvent& event);
  void set_z_up(bool z_up);
  void place_help();
  bool is_waiting_for_cage() const;
  void render_with_cage();
  void render();
  void drag_to_cursor();
  void show_speed();

  Editor& editor_;
  std::unique_ptr<Canvas> canvas_;
  vtkNew<vtkRenderer> renderer_;
  vtkSmartPointer<vtkOrientationMarkerWidget> axes_;
  std::unique_ptr<SceneView> scene_;
  std::unique_ptr<CameraControl> camera_;
  std::unique_ptr<SlideHandles> handles_;
  std::unique_ptr<ViewSync> sync_;
  std::unique_ptr<StrokeTool> stroke_tool_;
  std::unique_ptr<SelectTool> select_tool_;
  Tool* tool_ = nullptr;
  SlideHandles::Mode handle_mode_ = SlideHandles::Mode::none;
  Doing doing_ = Doing::nothing;
  std::vector<const QAction*> cancels_drag_;
  QPointF last_;
  bool render_is_due_ = false;
  QTimer late_frame_, speed_timer_;
  SpeedMeter::Clock::time_point drawn_;  // when the change was made that the drawn cage answers
  std::function<void()> hint_changed_, look_changed_;
  SpeedMeter speed_;
  QLabel *help_ = nullptr, *speed_label_ = nullptr;
};

}  // namespace cagewright::host

#endif
