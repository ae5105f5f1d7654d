// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_APP_STROKE_TOOL_H
#define CAGEWRIGHT_HOST_APP_STROKE_TOOL_H

#include <optional>
#include <vector>

#include "host/app/editor.h"
#include "host/app/tool.h"
#include "host/view/window/scene_view.h"

namespace cagewright::host {

// Draws strokes on the model; each becomes a slide. A click is a slide through that point, across the limb there.
class StrokeTool : public Tool {
 public:
  StrokeTool(Editor& editor, SceneView& view) : editor_(editor), view_(view) {}

  // On: a stroke across a limb is enough, the loop of its plane is found. Off: the ellipse is fitted to what was drawn
  // alone, and a stroke that begins with shift adds to the selected slide's.
  void set_complete(bool complete) { complete_ = complete; }
  bool completes() const { return complete_; }

  bool press(const MousePoint& at) override;
  void drag(const MousePoint& at) override;
  void release(const MousePoint& at) override;
  bool cancel() override;
  QString hint() const override;

 private:
  void sample(const MousePoint& at);
  void draw_to(const MousePoint& at);
  void show_preview();
  void finish_click();
  void finish_stroke();
  bool is_click() const;
  Point3 line_of_sight() const;

  Editor& editor_;
  SceneView& view_;
  bool complete_ = true;
  bool is_drawing_ = false;
  std::int64_t adds_to_ = -1;  // the slide whose stroke goes on; -1: a new one
  MousePoint first_, last_;
  MousePoint first_seen_, last_seen_;  // of the stroke on the model
  double farthest_ = 0;                // from first_, pixels
  std::vector<Point3> stroke_;
};

}  // namespace cagewright::host

#endif
