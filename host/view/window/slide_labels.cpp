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
constexpr double kGap = 10;                // pixels from the ellipse, and between labels
constexpr std::size_t kMostSentences = 5;  // more would hide the model
constexpr int kOutlineSegments = 96;       // where it is near, some are still within the window

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

// The nearest place above or below at which the box meets no other and is within the window; false: there is none.
bool move_off(Box& box, const std::vector<Box>& taken, const Projection& window, double gap) {
  std::vector<double> heights{box.y};
  for (const Box& other : taken) {
    heights.push_back(other.y - box.height - gap);
    heights.push_back(other.y + other.height + gap);
  }
  std::ranges::stable_sort(heights, {}, [&](double height) { return std::abs(height - box.y); });
  for (const double height : heights) {
    const Box moved{box.x, height, box.width, box.height};
    const bool is_inside = height >= window.origin[1] && height + box.height <= window.origin[1] + window.size[1];
    if (!is_inside || std::ranges::any_of(taken, [&](const Box& other) { return moved.meets(other); })) continue;
    box = moved;
    return true;
  }
  return false;
}

std::array<double, 2> size_of(vtkTextActor& text, vtkRenderer& renderer) {
  std::array<double, 2> size{};
  text.GetSize(&renderer, size.data());
  return size;
}

void put(vtkTextActor& text, const Box& box) {
  text.SetDisplayPosition(static_cast<int>(std::lround(box.x)), static_cast<int>(std::lround(box.y)));
}

vtkSmartPointer<vtkTextActor> make_text(const std::string& words, bool failed) {
  auto actor = vtkSmartPointer<vtkTextActor>::New();
  actor->SetInput(words.c_str());
  actor->PickableOff();
  vtkTextProperty* text = actor->GetTextProperty();
  const Point3& colour = failed ? colours::failed_slide : colours::selected_slide;
  // On its dark ground the failed slides' own colour is hard to read: half way to white.
  const double lighter = failed ? 0.45 : 0.2;
  text->SetColor(colour[0] + lighter * (1 - colour[0]), colour[1] + lighter * (1 - colour[1]),
                 colour[2] + lighter * (1 - colour[2]));
  text->SetFontFamilyToArial();
  text->SetFontSize(kFontSize);
  text->SetBackgroundColor(0.08, 0.08, 0.09);
  text->SetBackgroundOpacity(0.8);
  text->SetJustificationToLeft();
  text->SetVerticalJustificationToBottom();
  return actor;
}

}  // namespace

SlideLabels::SlideLabels(vtkRenderer& renderer) : renderer_(renderer), more_(make_text("", true)) {
  more_->VisibilityOff();
  renderer_.AddActor2D(more_);
}

SlideLabels::~SlideLabels() {
  for (const Label& label : labels_) renderer_.RemoveActor2D(label.actor);
  renderer_.RemoveActor2D(more_);
}

void SlideLabels::add(const ShownSlide& slide) {
  Label label{slide.label, slide.failed, {}, make_text(wrapped(slide.label, kLineLength), slide.failed)};
  renderer_.AddActor2D(label.actor);
  labels_.push_back(std::move(label));
}

void SlideLabels::set(const std::vector<ShownSlide>& slides) {
  std::vector<const ShownSlide*> labelled;
  for (const ShownSlide& slide : slides) {
    if (has_label(slide)) labelled.push_back(&slide);
  }
  // Where there are too many, those of the slides that somebody looks at are shown.
  std::ranges::stable_partition(labelled, [](const ShownSlide* slide) { return slide->is_selected; });
  const bool same_texts = std::ranges::equal(labelled, labels_, [](const ShownSlide* slide, const Label& label) {
    return slide->label == label.text && slide->failed == label.failed;
  });
  if (!same_texts) {
    for (const Label& label : labels_) renderer_.RemoveActor2D(label.actor);
    labels_.clear();
    for (const ShownSlide* slide : labelled) add(*slide);
  }
  for (std::size_t i = 0; i < labelled.size(); ++i) {
    const Slide::Ellipse& ellipse = labelled[i]->ellipse;
    labels_[i].outline = ellipse_points(ellipse.center, ellipse.u, ellipse.v, kOutlineSegments);
  }
  set_visible(visible_);
}

void SlideLabels::set_visible(bool visible) {
  visible_ = visible;
  for (const Label& label : labels_) label.actor->SetVisibility(visible_);
  more_->SetVisibility(false);  // place() knows
}

// In the upper left corner, in a row of its own.
void SlideLabels::place_more(std::size_t count) {
  const std::string text = "and " + std::to_string(count) + " more: see Problems";
  if (text != more_->GetInput()) more_->SetInput(text.c_str());
  const Projection projection(renderer_);
  const double gap = kGap * pixel_ratio(renderer_);
  const auto [width, height] = size_of(*more_, renderer_);
  put(*more_, {projection.origin[0] + gap, projection.origin[1] + projection.size[1] - height - gap, width, height});
  more_->VisibilityOn();
}

void SlideLabels::place(const Eigen::Matrix4d& to_scene) {
  if (!visible_) return;
  const Projection projection(renderer_);
  const double gap = kGap * pixel_ratio(renderer_);
  const double row = 2 * kFontSize * pixel_ratio(renderer_) + gap;  // of place_more
  std::vector<Box> taken = {
      {projection.origin[0], projection.origin[1] + projection.size[1] - row, projection.size[0], row}};
  std::size_t shown = 0, left_out = 0;
  for (const Label& label : labels_) {
    Projection::Seen rightmost, leftmost;
    for (const Point3& point : label.outline) {
      const auto seen = projection.see(transformed(to_scene, to_vector(point)));
      if (!is_within(seen, projection)) continue;
      if (!rightmost.is_visible || seen.x > rightmost.x) rightmost = seen;
      if (!leftmost.is_visible || seen.x < leftmost.x) leftmost = seen;
    }
    label.actor->VisibilityOff();
    if (!rightmost.is_visible) continue;
    if (label.failed && shown == kMostSentences) {
      ++left_out;
      continue;
    }
    const auto [width, height] = size_of(*label.actor, renderer_);
    Box box{rightmost.x + gap, rightmost.y - height / 2, width, height};
    const double left = leftmost.x - gap - box.width;
    if (box.x + box.width > projection.origin[0] + projection.size[0] && left >= projection.origin[0]) {
      box.x = left;
      box.y = leftmost.y - box.height / 2;
    }
    keep_within(box, projection);
    const bool has_room = move_off(box, taken, projection, gap / 2);
    if (label.failed) ++(has_room ? shown : left_out);
    if (!has_room) continue;
    taken.push_back(box);
    put(*label.actor, box);
    label.actor->VisibilityOn();
  }
  more_->VisibilityOff();
  if (left_out > 0) place_more(left_out);
}

}  // namespace cagewright::host
