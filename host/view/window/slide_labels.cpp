// SPDX-License-Identifier: BSD-3-Clause
#include "host/view/window/slide_labels.h"

#include <vtkRenderer.h>
#include <vtkTextProperty.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "host/view/polydata.h"
#include "host/view/window/colours.h"
#include "host/view/window/projection.h"
#include "host/view/window/text_wrap.h"

namespace cagewright::host {
namespace {

constexpr std::size_t kLineLength = 60;  // characters
constexpr int kFontSize = 13;
constexpr double kGap = 10;           // pixels from the ellipse, and between labels
constexpr int kOutlineSegments = 96;  // where it is near, some are still within the window

bool has_label(const ShownSlide& slide) { return (slide.failed || slide.is_selected) && !slide.label.empty(); }

struct Box {
  double x = 0, y = 0, width = 0, height = 0;  // display coordinates of the lower left corner
  bool meets(const Box& other) const {
    return x < other.x + other.width && other.x < x + width && y < other.y + other.height && other.y < y + height;
  }
};

bool is_within(const Projection::Seen& seen, const Projection& window) {
  return seen.is_visible && seen.x >= window.origin[0] && seen.x <= window.origin[0] + window.size[0] &&
         seen.y >= window.origin[1] && seen.y <= window.origin[1] + window.size[1];
}

void keep_within(Box& box, const Projection& window) {
  box.x = std::max(window.origin[0], std::min(box.x, window.origin[0] + window.size[0] - box.width));
  box.y = std::max(window.origin[1], std::min(box.y, window.origin[1] + window.size[1] - box.height));
}

}  // namespace

SlideLabels::SlideLabels(vtkRenderer& renderer) : renderer_(renderer) {}

SlideLabels::~SlideLabels() {
  for (const Label& label : labels_) renderer_.RemoveActor2D(label.actor);
}

void SlideLabels::add(const ShownSlide& slide) {
  Label label{slide.label, slide.failed, {}, vtkSmartPointer<vtkTextActor>::New()};
  label.actor->SetInput(wrapped(slide.label, kLineLength).c_str());
  label.actor->PickableOff();
  vtkTextProperty* text = label.actor->GetTextProperty();
  const Point3& colour = slide.failed ? colours::failed_slide : colours::selected_slide;
  // On its dark ground the failed slides' own colour is hard to read: half way to white.
  const double lighter = slide.failed ? 0.45 : 0.2;
  text->SetColor(colour[0] + lighter * (1 - colour[0]), colour[1] + lighter * (1 - colour[1]),
                 colour[2] + lighter * (1 - colour[2]));
  text->SetFontFamilyToArial();
  text->SetFontSize(kFontSize);
  text->SetBackgroundColor(0.08, 0.08, 0.09);
  text->SetBackgroundOpacity(0.8);
  text->SetJustificationToLeft();
  text->SetVerticalJustificationToBottom();
  renderer_.AddActor2D(label.actor);
  labels_.push_back(std::move(label));
}

void SlideLabels::set(const std::vector<ShownSlide>& slides) {
  const bool same_texts = [&] {
    std::size_t next = 0;
    for (const ShownSlide& slide : slides) {
      if (!has_label(slide)) continue;
      if (next == labels_.size() || labels_[next].text != slide.label || labels_[next].failed != slide.failed) {
        return false;
      }
      ++next;
    }
    return next == labels_.size();
  }();
  if (!same_texts) {
    for (const Label& label : labels_) renderer_.RemoveActor2D(label.actor);
    labels_.clear();
  }
  std::size_t next = 0;
  for (const ShownSlide& slide : slides) {
    if (!has_label(slide)) continue;
    if (!same_texts) add(slide);
    labels_[next++].outline = ellipse_points(slide.ellipse.center, slide.ellipse.u, slide.ellipse.v, kOutlineSegments);
  }
  set_visible(visible_);
}

void SlideLabels::set_visible(bool visible) {
  visible_ = visible;
  for (const Label& label : labels_) label.actor->SetVisibility(visible_);
}

void SlideLabels::place(const Eigen::Matrix4d& to_scene) {
  if (!visible_) return;
  const Projection projection(renderer_);
  const double gap = kGap * pixel_ratio(renderer_);
  std::vector<Box> taken;
  for (const Label& label : labels_) {
    Projection::Seen rightmost, leftmost;
    for (const Point3& point : label.outline) {
      const auto seen = projection.see(transformed(to_scene, to_vector(point)));
      if (!is_within(seen, projection)) continue;
      if (!rightmost.is_visible || seen.x > rightmost.x) rightmost = seen;
      if (!leftmost.is_visible || seen.x < leftmost.x) leftmost = seen;
    }
    label.actor->SetVisibility(rightmost.is_visible);
    if (!rightmost.is_visible) continue;
    std::array<double, 2> size{};
    label.actor->GetSize(&renderer_, size.data());
    Box box{rightmost.x + gap, rightmost.y - size[1] / 2, size[0], size[1]};
    const double left = leftmost.x - gap - box.width;
    if (box.x + box.width > projection.origin[0] + projection.size[0] && left >= projection.origin[0]) {
      box.x = left;
      box.y = leftmost.y - box.height / 2;
    }
    keep_within(box, projection);
    for (const Box& other : taken) {  // in the order in which they were moved down
      if (box.meets(other)) box.y = other.y - box.height - gap / 2;
    }
    taken.push_back(box);
    label.actor->SetDisplayPosition(static_cast<int>(std::lround(box.x)), static_cast<int>(std::lround(box.y)));
  }
}

}  // namespace cagewright::host
