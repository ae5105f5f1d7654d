// SPDX-License-Identifier: BSD-3-Clause
#include "host/view/window/slide_actors.h"

#include <cstddef>
#include <utility>

#include "host/view/window/colours.h"

namespace cagewright::host {
namespace {

using Runs = std::vector<std::vector<Point>>;

constexpr double kOpacityOfHidden = 0.30;

std::vector<Point> outline(const Slide::Ellipse& ellipse) {
  return ellipse_points(ellipse.center, ellipse.u, ellipse.v, kEllipseSegments);
}

// Three segments drawn, three left out.
void add_dashes(const std::vector<Point>& outline, Runs& runs) {
  constexpr std::size_t kDash = 3;
  static_assert(kEllipseSegments % (2 * kDash) == 0);
  for (std::size_t i = 0; i < outline.size(); i += 2 * kDash) {
    runs.emplace_back(outline.begin() + static_cast<std::ptrdiff_t>(i),
                      outline.begin() + static_cast<std::ptrdiff_t>(i + kDash + 1));
  }
}

}  // namespace

SlideActors::SlideActors(vtkRenderer& renderer)
    : plain_(renderer, {colours::slide, 2.5, 1, kOpacityOfHidden}),
      selected_(renderer, {colours::selected_slide, 3, 1, 0.5}),
      preview_(renderer, {colours::preview_slide, 2.5, 1, kOpacityOfHidden}),
      failed_(renderer, {colours::failed_slide, 3, 1, 0.5}),
      failed_selected_(renderer, {colours::selected_slide, 3, 1, 0.5}) {}

void SlideActors::set(const std::vector<ShownSlide>& slides) {
  Runs plain, selected, preview, failed, failed_selected;
  for (const ShownSlide& slide : slides) {
    if (slide.failed) {
      add_dashes(outline(slide.ellipse), slide.is_selected ? failed_selected : failed);
    } else {
      (slide.is_preview ? preview : slide.is_selected ? selected : plain).push_back(outline(slide.ellipse));
    }
  }
  plain_.set(std::move(plain), true);
  selected_.set(std::move(selected), true);
  preview_.set(std::move(preview), true);
  failed_.set(std::move(failed), false);
  failed_selected_.set(std::move(failed_selected), false);
}

void SlideActors::set_transform(const Matrix4& to_scene) {
  for (LineActor* lines : all()) lines->set_transform(to_scene);
}

void SlideActors::set_visible(bool visible) {
  for (LineActor* lines : all()) lines->set_visible(visible);
}

void SlideActors::set_pixel_ratio(double ratio) {
  for (LineActor* lines : all()) lines->set_pixel_ratio(ratio);
}

}  // namespace cagewright::host
