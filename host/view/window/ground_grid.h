// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_VIEW_WINDOW_GROUND_GRID_H
#define CAGEWRIGHT_HOST_VIEW_WINDOW_GROUND_GRID_H

#include <array>

#include "host/view/window/line_actor.h"

namespace cagewright::host {

// A square grid under what is shown: across what is up, cells of a power of ten of the scene's units.
class GroundGrid {
 public:
  explicit GroundGrid(vtkRenderer& renderer);

  // {x0, x1, y0, y1, z0, z1}; at their lower end along `up`, 1 (y) or 2 (z).
  void fit(const std::array<double, 6>& bounds, int up);
  void set_look(bool visible, bool dark);
  void set_pixel_ratio(double ratio);

 private:
  LineActor lines_, axes_;
};

}  // namespace cagewright::host

#endif
