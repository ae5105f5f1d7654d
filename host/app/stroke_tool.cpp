// SPDX-License-Identifier: BSD-3-Clause
#include "host/app/stroke_tool.h"

#include <algorithm>
#include <cmath>
#include <exception>

namespace cagewright::host {
namespace {

constexpr double sample_pixels = 3;  // between samples: Qt reports few of a mouse's positions, the rest is interpolated
constexpr double click_pixels = 4;   // a shorter stroke is a click
constexpr std::size_t fewest_of_fit = 6;  // points that an ellipse can be fitted to

double distance(const MousePoint& a, const MousePoint& b) { return std::hypot(a.x - b.x, a.y - b.y); }

}  // namespace

bool StrokeTool::press(const MousePoint& at) {
  if (!editor_.workspace().has_scene() || !editor_.workspace().plugin()) return false;
  is_drawing_ = true;
  const std::vector<std::int64_t>& selection = editor_.workspace().selection();
  adds_to_ = !complete_ && at.shift && selection.size() == 1 ? selection.front() : -1;
  first_ = last_ = at;
  farthest_ = 0;
  stroke_.clear();
  sample(at);
  return true;
}

void StrokeTool::drag(const MousePoint& at) {
  if (!is_drawing_) return;
  draw_to(at);
  view_.set_stroke(stroke_);
  show_preview();
}

void StrokeTool::draw_to(const MousePoint& at) {
  farthest_ = std::max(farthest_, distance(first_, at));
  const double length = distance(last_, at);
  if (length < sample_pixels) return;
  const int steps = static_cast<int>(std::ceil(length / sample_pixels));
  for (int i = 1; i <= steps; ++i) {
    const double share = static_cast<double>(i) / steps;
    sample({last_.x + share * (at.x - last_.x), last_.y + share * (at.y - last_.y)});
  }
  last_ = at;
}

// A stroke may begin and end beside the limb, as that of a knife does.
void StrokeTool::sample(const MousePoint& at) {
  const std::optional<Hit> hit = view_.pick_model(at.x, at.y);
  if (!hit) return;
  if (stroke_.empty()) first_seen_ = at;
  last_seen_ = at;
  stroke_.push_back(hit->point);
}

bool StrokeTool::is_click() const { return farthest_ < click_pixels; }

Point3 StrokeTool::line_of_sight() const {
  return view_.ray((first_seen_.x + last_seen_.x) / 2, (first_seen_.y + last_seen_.y) / 2).direction;
}

// Nothing is said while the stroke is drawn: what cannot be fitted yet may be with the next point.
void StrokeTool::show_preview() {
  if (is_click() || stroke_.size() < 2 || (!complete_ && stroke_.size() < fewest_of_fit)) return;
  Workspace& workspace = editor_.workspace();
  try {
    if (complete_) {
      workspace.set_preview({{-1, workspace.fit_across(stroke_, line_of_sight())}});
    } else if (adds_to_ < 0) {
      workspace.set_preview({{-1, workspace.fit({"stroke", Slide::Stroke{stroke_}})}});
    }
  } catch (const std::exception&) {
    workspace.clear_preview();
  }
}

void StrokeTool::release(const MousePoint& at) {
  if (!is_drawing_) return;
  draw_to(at);
  is_drawing_ = false;
  view_.set_stroke({});
  if (stroke_.empty()) {
    editor_.attempt([] {
      throw CommandError(
          "the stroke misses the model: draw across it; the right mouse button, or Alt and the left, turns the view");
    });
  } else if (is_click()) {
    finish_click();
  } else {
    finish_stroke();
  }
  editor_.workspace().clear_preview();
}

void StrokeTool::finish_click() { editor_.run({{"command", "add_slide"}, {"point", stroke_.front()}}); }

void StrokeTool::finish_stroke() {
  if (adds_to_ >= 0) {
    if (const SceneSlide* slide = editor_.workspace().document().find_slide(adds_to_))
      editor_.run({{"command", "extend_stroke"}, {"slide", slide->name}, {"points", stroke_}});
    return;
  }
  nlohmann::json command = {{"command", "add_slide"}, {"stroke", stroke_}};
  if (complete_) command["line_of_sight"] = line_of_sight();
  command["complete"] = complete_;
  editor_.run(command);
}

bool StrokeTool::cancel() {
  if (!is_drawing_) return false;
  is_drawing_ = false;
  view_.set_stroke({});
  if (editor_.workspace().has_scene()) editor_.workspace().clear_preview();
  return true;
}

QString StrokeTool::hint() const {
  if (is_drawing_) return "Release the mouse where the stroke ends; Esc gives it up.";
  if (complete_) return "Draw a short stroke across a limb, or click on it: a cut slide goes round it there.";
  return "Draw round a limb: the ellipse is fitted to the stroke. Turn the view, hold Shift and draw on to add to it.";
}

}  // namespace cagewright::host
