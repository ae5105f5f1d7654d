// SPDX-License-Identifier: BSD-3-Clause
#include "host/view/window/colours.h"

#include <algorithm>
#include <cmath>

namespace cagewright::host {

Point3 colour_of_part(int part) {
  if (part < 0) return colours::model;
  // Hues a golden section apart stay apart for any number of parts; strength changes with every round of the circle.
  constexpr double kGoldenSection = 0.61803398874989485;
  // Red is left out: slides and what pokes out are red.
  constexpr double kFirstHue = 25.0 / 360, kLastHue = 335.0 / 360;
  const double turns = 0.58 + kGoldenSection * part;
  const double hue = 6 * (kFirstHue + (kLastHue - kFirstHue) * (turns - std::floor(turns)));
  const double saturation = part % 3 == 1 ? 0.40 : 0.58;
  const double value = part % 2 == 0 ? 0.88 : 0.74;
  Point3 colour{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double offset = std::fmod((i == 0 ? 5.0 : i == 1 ? 3.0 : 1.0) + hue, 6.0);
    colour[i] = value * (1 - saturation * std::clamp(std::min(offset, 4 - offset), 0.0, 1.0));
  }
  return colour;
}

}  // namespace cagewright::host
