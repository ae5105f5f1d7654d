// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_VIEW_WINDOW_SLIDE_HANDLES_H
#define CAGEWRIGHT_HOST_VIEW_WINDOW_SLIDE_HANDLES_H

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "host/view/window/scene_view.h"

namespace cagewright::host {

// Handles of the selected slides, as Maya's w, e, r: move along u, v and the normal, and in the plane; turn about u, v
// and the normal; scale along u, v and both. They stand at the last selected slide and act on all, each about its own
// centre (turn, scale) or by the same way (move). Same size on the screen at any distance. Main thread only (VTK).
class SlideHandles {
 public:
  enum class Mode { none, move, turn, scale };

  SlideHandles(vtkRenderer& renderer, const SceneView& view);
  ~SlideHandles();

  void set_mode(Mode mode);
  Mode mode() const;
  // In the active mesh's space; the last one carries the handles.
  void set_slides(std::vector<std::pair<std::int64_t, Slide::Ellipse>> slides);
  void update();  // after the camera moved

  // Display coordinates. Whether a handle is there: it is drawn brighter.
  bool hover(double x, double y);
  bool begin(double x, double y);  // whether a drag begins
  // Where the slides are then; `snap`: turns by 15 degrees, scales by tenths.
  std::vector<std::pair<std::int64_t, Slide::Ellipse>> drag(double x, double y, bool snap);
  void end();
  bool is_dragging() const;
  std::string label() const;  // of the drag, for undo: "move slide", "turn slide", "scale slide"
  // Of the handles, in the active mesh's space, for tests: where to press. Move: u, v, normal, the plane, the screen's
  // plane (ball); turn: u, v, normal; scale: u, v, both. Empty where none is shown.
  std::vector<Point3> places() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace cagewright::host

#endif
