// SPDX-License-Identifier: BSD-3-Clause
#include "host/view/tests/image.h"

#include <gtest/gtest.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>

#include <algorithm>

namespace cagewright::host {

long Image::count(const Colour& is, double left, double right) const {
  long found = 0;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const double x = (static_cast<double>(i % static_cast<std::size_t>(width)) + 0.5) / width;
    found += x >= left && x < right && is(pixels[i][0], pixels[i][1], pixels[i][2]) ? 1 : 0;
  }
  return found;
}

double Image::aspect(const Colour& is) const {
  int left = width, right = -1, bottom = height, top = -1;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const auto& [r, g, b] =
          pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
      if (!is(r, g, b)) continue;
      left = std::min(left, x), right = std::max(right, x);
      bottom = std::min(bottom, y), top = std::max(top, y);
    }
  }
  return top < 0 ? 0 : static_cast<double>(right - left + 1) / (top - bottom + 1);
}

double Image::mean_height(const Colour& is) const {
  double sum = 0;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const double y = (static_cast<double>(i / static_cast<std::size_t>(width)) + 0.5) / height;
    sum += is(pixels[i][0], pixels[i][1], pixels[i][2]) ? y : 0;
  }
  return sum / static_cast<double>(count(is));
}

Image read_png(const std::filesystem::path& path) {
  const vtkNew<vtkPNGReader> reader;
  EXPECT_EQ(reader->CanReadFile(path.c_str()), 3) << path;
  reader->SetFileName(path.c_str());
  reader->Update();
  vtkImageData* data = reader->GetOutput();
  Image image{data->GetDimensions()[0], data->GetDimensions()[1], {}};
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const auto* rgb = static_cast<const unsigned char*>(data->GetScalarPointer(x, y, 0));
      image.pixels.push_back({rgb[0], rgb[1], rgb[2]});
    }
  }
  return image;
}

}  // namespace cagewright::host
