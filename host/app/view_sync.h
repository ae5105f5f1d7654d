// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_APP_VIEW_SYNC_H
#define CAGEWRIGHT_HOST_APP_VIEW_SYNC_H

#include <memory>

#include "host/app/editor.h"
#include "host/view/window/scene_view.h"
#include "host/view/window/slide_handles.h"

namespace cagewright::host {

// Shows a workspace in a view: what has changed there, and nothing else.
class ViewSync {
 public:
  ViewSync(const Workspace& workspace, SceneView& view, SlideHandles& handles)
      : workspace_(workspace), view_(view), handles_(handles) {}

  void update(WorkspaceChange change);
  // Called when handles may have gone or come for another reason: their mode, the tool.
  void show_handles();

 private:
  void show_meshes();
  void show_slides();
  void show_cage();
  void show_open_edges();

  const Workspace& workspace_;
  SceneView& view_;
  SlideHandles& handles_;
  std::shared_ptr<const Report> coloured_by_;  // of the whole cage whose parts and coverage are shown
};

}  // namespace cagewright::host

#endif
