// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_VIEW_WINDOW_LINE_ACTOR_H
#define CAGEWRIGHT_HOST_VIEW_WINDOW_LINE_ACTOR_H

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>

#include <vector>

#include "host/view/polydata.h"
#include "host/view/window/scene_view.h"

namespace cagewright::host {

// How lines look.
struct LineStyle {
  Point3 colour{};
  double width = 1;              // pixels, before pixel_ratio()
  double opacity = 1;            // of what is seen
  double opacity_of_hidden = 0;  // of what lies behind other things; 0: it is not seen
};

// Lines of one colour in a renderer, unlit, of a width in pixels. Removes itself.
class LineActor {
 public:
  LineActor(vtkRenderer& renderer, const LineStyle& style);
  ~LineActor();
  LineActor(const LineActor&) = delete;
  LineActor& operator=(const LineActor&) = delete;

  // Uploads only where `runs` are others than before.
  void set(std::vector<std::vector<Point>> runs, bool closed);
  void set_style(const LineStyle& style);
  void set_transform(const Matrix4& to_scene);
  void set_visible(bool visible);
  void set_pixel_ratio(double ratio);
  void ignore_bounds();  // for clipping and framing it is not there

 private:
  void apply();

  vtkRenderer& renderer_;
  LineStyle style_;
  double ratio_ = 1;
  bool visible_ = true;
  bool closed_ = false;
  std::vector<std::vector<Point>> runs_;
  vtkNew<vtkPolyDataMapper> mapper_, hidden_mapper_;
  vtkNew<vtkActor> actor_, hidden_actor_;
};

}  // namespace cagewright::host

#endif
