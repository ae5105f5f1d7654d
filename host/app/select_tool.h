// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_APP_SELECT_TOOL_H
#define CAGEWRIGHT_HOST_APP_SELECT_TOOL_H

#include "host/app/editor.h"
#include "host/app/tool.h"
#include "host/view/window/scene_view.h"
#include "host/view/window/slide_handles.h"

namespace cagewright::host {

// Selects slides and drags their handles; the cage follows the drag, which is one step of undo.
class SelectTool : public Tool {
 public:
  SelectTool(Editor& editor, SceneView& view, SlideHandles& handles)
      : editor_(editor), view_(view), handles_(handles) {}

  bool press(const MousePoint& at) override;
  void drag(const MousePoint& at) override;
  void release(const MousePoint& at) override;
  bool hover(const MousePoint& at) override;
  bool cancel() override;
  QString hint() const override;

 private:
  bool was_over_handle_ = false;
  void select(std::int64_t slide, const MousePoint& at);

  Editor& editor_;
  SceneView& view_;
  SlideHandles& handles_;
};

}  // namespace cagewright::host

#endif
