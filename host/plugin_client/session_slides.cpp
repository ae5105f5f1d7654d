// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <set>
#include <utility>

#include "host/plugin_client/plugin_error.h"
#include "host/plugin_client/session.h"

namespace cagewright::host {
namespace {

void copy(const Point3& from, double (&to)[3]) { std::copy(from.begin(), from.end(), to); }

// Borrows the slide's name and stroke.
cgw_slide_input to_input(const Slide& slide) {
  cgw_slide_input input = CGW_SLIDE_INPUT_INIT;
  input.name = slide.name.c_str();
  if (const auto* stroke = std::get_if<Slide::Stroke>(&slide.shape)) {
    static_assert(sizeof(Point3) == 3 * sizeof(double));
    input.kind = CGW_SLIDE_STROKE;
    input.stroke = stroke->points.empty() ? nullptr : stroke->points.front().data();
    input.stroke_count = stroke->points.size();
  } else if (const auto* plane = std::get_if<Slide::PointNormal>(&slide.shape)) {
    input.kind = CGW_SLIDE_POINT_NORMAL;
    copy(plane->point, input.point);
    copy(plane->normal, input.normal);
  } else if (const auto* ellipse = std::get_if<Slide::Ellipse>(&slide.shape)) {
    input.kind = CGW_SLIDE_ELLIPSE;
    copy(ellipse->center, input.point);
    copy(ellipse->u, input.u);
    copy(ellipse->v, input.v);
  } else if (const auto* click = std::get_if<Slide::Point>(&slide.shape)) {
    input.kind = CGW_SLIDE_POINT;
    copy(click->point, input.point);
  }
  return input;
}

bool has_name(const std::vector<Slide>& slides, const std::string& name) {
  return std::any_of(slides.begin(), slides.end(), [&](const Slide& slide) { return slide.name == name; });
}

}  // namespace

std::uint64_t Session::add_slide(const Slide& slide) {
  const cgw_slide_input input = to_input(slide);
  std::uint64_t id = CGW_NO_ID;
  check(api().slide_add(session_, &input, &id), "slide_add");
  slides_.emplace_back(id, slide);
  return id;
}

void Session::change_slide(std::uint64_t id, const Slide& slide) {
  const cgw_slide_input input = to_input(slide);
  check(api().slide_change(session_, id, &input), "slide_change");
  for (auto& [own_id, own] : slides_)
    if (own_id == id) own = slide;
}

void Session::remove_slide(std::uint64_t id) {
  check(api().slide_remove(session_, id), "slide_remove");
  std::erase_if(slides_, [id](const auto& own) { return own.first == id; });
}

std::vector<std::uint64_t> Session::set_slides(const std::vector<Slide>& slides) {
  std::vector<Slide> before;
  for (const auto& [id, slide] : slides_) before.push_back(slide);
  try {
    follow(slides);
  } catch (const PluginError&) {
    follow(before);
    throw;
  }
  std::vector<std::uint64_t> ids;
  for (const auto& [id, slide] : slides_) ids.push_back(id);
  return ids;
}

void Session::follow(const std::vector<Slide>& slides) {
  std::set<std::string> names;
  for (const auto& [id, own] : slides_) names.insert(own.name);
  std::size_t k = 0;
  while (k < slides.size() && k < slides_.size()) {
    const auto& [id, own] = slides_[k];
    if (own.name != slides[k].name) {
      if (has_name(slides, own.name)) break;  // another comes before it
      if (names.count(slides[k].name) > 0) {
        remove_slide(id);
        continue;
      }
    }
    if (!(own == slides[k])) change_slide(id, slides[k]);
    ++k;
  }
  while (slides_.size() > k) remove_slide(slides_.back().first);
  for (; k < slides.size(); ++k) add_slide(slides[k]);
}

std::vector<SlideInfo> Session::slides() const {
  std::vector<SlideInfo> slides(api().slide_count(session_));
  for (std::size_t i = 0; i < slides.size(); ++i) {
    SlideInfo& slide = slides[i];
    check(api().slide_info(session_, i, &slide.info), "slide_info");
    if (const char* name = std::exchange(slide.info.name, nullptr)) slide.name = name;
    if (const char* message = std::exchange(slide.info.message, nullptr)) slide.message = message;
  }
  return slides;
}

Slide::Ellipse Session::fit(const Slide& slide) const {
  if (!plugin_->has_slide_fit()) {
    cgw_error_info info = CGW_ERROR_INFO_INIT;
    info.code = CGW_ERROR_INVALID_ARGUMENT;
    throw PluginError(info, "the plug-in " + plugin_->path().string() + " has ABI " + std::to_string(api().abi_major) +
                                "." + std::to_string(api().abi_minor) +
                                ", but to fit a slide needs 1.3: load a newer plug-in");
  }
  const cgw_slide_input input = to_input(slide);
  cgw_slide_info info = CGW_SLIDE_INFO_INIT;
  check(api().slide_fit(session_, &input, &info), "slide_fit");
  return {std::to_array(info.center), std::to_array(info.u), std::to_array(info.v)};
}

std::vector<Point3> Session::loop(std::size_t index) const {
  cgw_loop loop = CGW_LOOP_INIT;
  check(api().get_loop(session_, index, &loop), "get_loop");
  std::vector<Point3> points(loop.point_count);
  static_assert(sizeof(Point3) == 3 * sizeof(double));
  loop.points = points.empty() ? nullptr : points.front().data();
  loop.point_capacity = loop.point_count;
  check(api().get_loop(session_, index, &loop), "get_loop");
  return points;
}

}  // namespace cagewright::host
