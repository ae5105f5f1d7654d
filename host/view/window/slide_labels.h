// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_VIEW_WINDOW_SLIDE_LABELS_H
#define CAGEWRIGHT_HOST_VIEW_WINDOW_SLIDE_LABELS_H

#include <vtkSmartPointer.h>
#include <vtkTextActor.h>

#include <Eigen/Core>
#include <string>
#include <vector>

#include "host/view/window/scene_view.h"

namespace cagewright::host {

// Text beside slides that failed or are selected, to the right of their ellipses or, where there is no room, to the
// left; within the window, not over one another. Of failed slides a few, those that are selected first; how many more
// there are is said in the corner. Of a slide that is off the window there is none: at the window's edge
// it would be beside something else.
class SlideLabels {
 public:
  explicit SlideLabels(vtkRenderer& renderer);
  ~SlideLabels();
  SlideLabels(const SlideLabels&) = delete;
  SlideLabels& operator=(const SlideLabels&) = delete;

  void set(const std::vector<ShownSlide>& slides);
  void set_visible(bool visible);
  // To where the camera now sees the slides. Before each frame.
  void place(const Eigen::Matrix4d& to_scene);

 private:
  struct Label {
    std::string text;
    bool failed = false;
    std::vector<Point3> outline;
    vtkSmartPointer<vtkTextActor> actor;
  };
  void add(const ShownSlide& slide);
  void place_more(std::size_t count);

  vtkRenderer& renderer_;
  std::vector<Label> labels_;  // in the order in which they are given room
  vtkSmartPointer<vtkTextActor> more_;
  bool visible_ = true;
};

}  // namespace cagewright::host

#endif
