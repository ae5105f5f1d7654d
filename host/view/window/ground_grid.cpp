// SPDX-License-Identifier: BSD-3-Clause
#include "host/view/window/ground_grid.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace cagewright::host {
namespace {

constexpr LineStyle kDarkLines{{0.27, 0.27, 0.29}, 1}, kLightLines{{0.72, 0.73, 0.75}, 1};
constexpr LineStyle kDarkAxes{{0.40, 0.40, 0.43}, 1.5}, kLightAxes{{0.52, 0.53, 0.56}, 1.5};

}  // namespace

GroundGrid::GroundGrid(vtkRenderer& renderer) : lines_(renderer, kDarkLines), axes_(renderer, kDarkAxes) {
  fit({-1, 1, 0, 1, -1, 1}, 1);
}

void GroundGrid::fit(const std::array<double, 6>& bounds, int up) {
  const double extent = std::max({bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4]});
  if (!(extent > 0) || !std::isfinite(extent)) return;
  // 6 to 60 cells across the scene; the grid is some cells larger than the scene.
  const double cell = std::pow(10.0, std::floor(std::log10(extent / 6)));
  const auto index = [&](double coordinate) { return std::round(coordinate / cell); };
  const double across = std::ceil(0.75 * extent / cell) + 1;
  const std::size_t vertical = static_cast<std::size_t>(up), depth = 3 - vertical;
  const auto middle = [&](std::size_t axis) { return index((bounds[2 * axis] + bounds[2 * axis + 1]) / 2); };
  const double x = middle(0), z = middle(depth);
  const double x0 = (x - across) * cell, x1 = (x + across) * cell, z0 = (z - across) * cell, z1 = (z + across) * cell;
  const auto point = [&](double along_x, double along_depth) {
    Point at{along_x, 0, 0};
    at[vertical] = bounds[2 * vertical];
    at[depth] = along_depth;
    return at;
  };
  std::vector<std::vector<Point>> lines, axes;
  for (double i = -across; i <= across; ++i) {
    const bool is_depth_axis = x + i == 0, is_x_axis = z + i == 0;
    (is_depth_axis ? axes : lines).push_back({point((x + i) * cell, z0), point((x + i) * cell, z1)});
    (is_x_axis ? axes : lines).push_back({point(x0, (z + i) * cell), point(x1, (z + i) * cell)});
  }
  lines_.set(std::move(lines), false);
  axes_.set(std::move(axes), false);
}

void GroundGrid::set_look(bool visible, bool dark) {
  lines_.set_visible(visible);
  axes_.set_visible(visible);
  lines_.set_style(dark ? kDarkLines : kLightLines);
  axes_.set_style(dark ? kDarkAxes : kLightAxes);
}

void GroundGrid::set_pixel_ratio(double ratio) {
  lines_.set_pixel_ratio(ratio);
  axes_.set_pixel_ratio(ratio);
}

}  // namespace cagewright::host
