// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_VIEW_WINDOW_SLIDE_ACTORS_H
#define CAGEWRIGHT_HOST_VIEW_WINDOW_SLIDE_ACTORS_H

#include <array>
#include <vector>

#include "host/view/window/line_actor.h"
#include "host/view/window/scene_view.h"

namespace cagewright::host {

constexpr int kEllipseSegments = 72;

// The slides' ellipses: one actor for each look. A look whose slides have not changed is not uploaded again.
class SlideActors {
 public:
  explicit SlideActors(vtkRenderer& renderer);

  void set(const std::vector<ShownSlide>& slides);
  void set_transform(const Matrix4& to_scene);
  void set_visible(bool visible);
  void set_pixel_ratio(double ratio);

 private:
  LineActor plain_, selected_, preview_, failed_, failed_selected_;
  std::array<LineActor*, 5> all() { return {&plain_, &selected_, &preview_, &failed_, &failed_selected_}; }
};

}  // namespace cagewright::host

#endif
