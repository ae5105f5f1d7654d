// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_VIEW_TESTS_IMAGE_H
#define CAGEWRIGHT_HOST_VIEW_TESTS_IMAGE_H

#include <array>
#include <filesystem>
#include <functional>
#include <vector>

namespace cagewright::host {

// A picture as its pixels.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::array<int, 3>> pixels;  // rows from the bottom

  using Colour = std::function<bool(int, int, int)>;

  // Pixels in columns [left, right) of the width for which `is` holds.
  long count(const Colour& is, double left = 0, double right = 1) const;
  // Width over height of the box round the pixels for which `is` holds; 0 where there are none.
  double aspect(const Colour& is) const;
  // Their mean row, from 0 at the bottom to 1 at the top.
  double mean_height(const Colour& is) const;
};

// Expects the file to be a PNG.
Image read_png(const std::filesystem::path& path);

}  // namespace cagewright::host

#endif
