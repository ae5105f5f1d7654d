// SPDX-License-Identifier: BSD-3-Clause
#include "host/app/select_tool.h"

#include <algorithm>
#include <vector>

namespace cagewright::host {

bool SelectTool::press(const MousePoint& at) {
  if (!editor_.workspace().has_scene()) return false;
  if (handles_.begin(at.x, at.y)) return true;
  const Hit hit = view_.pick(at.x, at.y, true);
  if (hit.what != Hit::What::slide) {
    if (!at.shift && hit.what != Hit::What::model && hit.what != Hit::What::cage &&
        !editor_.workspace().selection().empty())
      editor_.run({{"command", "select"}, {"slides", nlohmann::json::array()}});
    return false;
  }
  select(hit.slide, at);
  return true;
}

void SelectTool::select(std::int64_t slide, const MousePoint& at) {
  std::vector<std::int64_t> ids = {slide};
  if (at.shift) {
    ids = editor_.workspace().selection();
    if (const auto found = std::find(ids.begin(), ids.end(), slide); found != ids.end())
      ids.erase(found);
    else
      ids.push_back(slide);
  }
  nlohmann::json names = nlohmann::json::array();
  for (const std::int64_t id : ids) names.push_back(editor_.workspace().document().find_slide(id)->name);
  editor_.run({{"command", "select"}, {"slides", names}});
}

void SelectTool::drag(const MousePoint& at) {
  if (!handles_.is_dragging()) return;
  std::vector<PreviewSlide> preview;
  for (const auto& [id, ellipse] : handles_.drag(at.x, at.y, at.control)) preview.push_back({id, ellipse});
  editor_.workspace().set_preview(std::move(preview));
}

void SelectTool::release(const MousePoint& at) {
  if (!handles_.is_dragging()) return;
  const auto moved = handles_.drag(at.x, at.y, at.control);
  const std::string label = handles_.label();
  handles_.end();
  nlohmann::json slides = nlohmann::json::array();
  bool any = false;
  for (const auto& [id, ellipse] : moved) {
    const SceneSlide* slide = editor_.workspace().document().find_slide(id);
    if (!slide) continue;
    any = any || slide->ellipse.center != ellipse.center || slide->ellipse.u != ellipse.u ||
          slide->ellipse.v != ellipse.v;
    slides.push_back({{"name", slide->name}, {"center", ellipse.center}, {"u", ellipse.u}, {"v", ellipse.v}});
  }
  if (any) editor_.run({{"command", "change_slides"}, {"slides", slides}, {"label", label}});
  editor_.workspace().clear_preview();
}

bool SelectTool::hover(const MousePoint& at) {
  if (handles_.mode() == SlideHandles::Mode::none) return false;
  const bool is_over = handles_.hover(at.x, at.y), was_over = was_over_handle_;
  was_over_handle_ = is_over;
  return is_over || was_over;
}

bool SelectTool::cancel() {
  if (!handles_.is_dragging()) return false;
  handles_.end();
  if (editor_.workspace().has_scene()) editor_.workspace().clear_preview();
  return true;
}

QString SelectTool::hint() const {
  if (!editor_.workspace().has_scene()) return "Open a model or scene.";
  if (editor_.workspace().slides().empty()) return "No slides yet: take Draw Slides (D) and draw across a limb.";
  if (editor_.workspace().selection().empty())
    return "Click a slide to select it; drag beside the slides to turn the view.";
  switch (handles_.mode()) {
    case SlideHandles::Mode::move:
      return "Drag an arrow to move the slide; W, E, R: move, turn, scale.";
    case SlideHandles::Mode::turn:
      return "Drag a ring to turn the slide, Ctrl: by 15 degrees; W, E, R: move, turn, scale.";
    case SlideHandles::Mode::scale:
      return "Drag a box to scale the slide, Ctrl: by tenths; W, E, R: move, turn, scale.";
    case SlideHandles::Mode::none:
      break;
  }
  return "W, E, R: handles to move, turn or scale the slide; Del removes it, Ctrl+D duplicates it.";
}

}  // namespace cagewright::host
