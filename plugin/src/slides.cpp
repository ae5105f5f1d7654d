// SPDX-License-Identifier: BSD-3-Clause
#include "plugin/src/slides.h"

#include <algorithm>
#include <new>

#include "core/slide/fit_ellipse.h"
#include "core/slide/plane_loops.h"

namespace cagewright::plugin {

namespace {

// Empty for a point, with a normal or alone: its ellipse needs the model.
std::optional<Ellipse> ellipse_without_model(const Slide& slide) {
  check_definition(slide);
  if (const auto* stroke = std::get_if<StrokeDefinition>(&slide.definition)) {
    return fit_stroke(stroke->points, slide.name);
  }
  if (const auto* ellipse = std::get_if<EllipseDefinition>(&slide.definition)) {
    return from_radii(*ellipse, slide.name);
  }
  return std::nullopt;
}

}  // namespace

std::unique_ptr<SlideEntry> SlideList::checked(Slide slide, std::uint64_t id, std::uint64_t id_in_errors) const {
  for (const auto& entry : entries_) {
    if (entry->id == id || entry->slide.name != slide.name) continue;
    cgw_error_info info = CGW_ERROR_INFO_INIT;
    info.code = CGW_ERROR_SLIDE_NAME;
    info.slide = id_in_errors;
    info.other_slide = entry->id;
    throw AbiError(info, "slide '" + slide.name + "': another slide has that name; choose one that is not taken");
  }
  try {
    auto entry = std::make_unique<SlideEntry>();
    entry->id = id;
    entry->ellipse = ellipse_without_model(slide);
    entry->slide = std::move(slide);
    return entry;
  } catch (const Error& error) {
    cgw_error_info info = to_abi_error(error, {}).info();
    info.slide = id_in_errors;
    throw AbiError(info, error.what());
  }
}

std::uint64_t SlideList::add(Slide slide) {
  entries_.push_back(checked(std::move(slide), next_id_, CGW_NO_ID));
  return next_id_++;
}

void SlideList::add_as(std::uint64_t id, Slide slide) {
  const auto has_id = [id](const auto& entry) { return entry->id == id; };
  if (std::any_of(entries_.begin(), entries_.end(), has_id)) {
    throw AbiError(CGW_ERROR_SLIDE_NAME, "slide '" + slide.name + "': its id is taken by another slide");
  }
  entries_.push_back(checked(std::move(slide), id, id));
  reserve_ids_below(id + 1);
}

void SlideList::change(std::uint64_t id, Slide slide) {
  const std::size_t index = index_of(id);
  entries_[index] = checked(std::move(slide), id, id);
}

void SlideList::remove(std::uint64_t id) {
  entries_.erase(entries_.begin() + static_cast<std::ptrdiff_t>(index_of(id)));
}

std::size_t SlideList::index_of(std::uint64_t id) const {
  for (std::size_t k = 0; k < entries_.size(); ++k) {
    if (entries_[k]->id == id) return k;
  }
  cgw_error_info info = CGW_ERROR_INFO_INIT;
  info.code = CGW_ERROR_UNKNOWN_SLIDE;
  info.slide = id;
  throw AbiError(info, "there is no slide with the id " + std::to_string(id) + "; it was removed or never added");
}

std::vector<Slide> SlideList::on_model(const HalfEdgeMesh& mesh) {
  std::vector<Slide> slides;
  slides.reserve(entries_.size());
  for (const auto& entry : entries_) {
    const bool is_point = std::holds_alternative<PointDefinition>(entry->slide.definition);
    if (is_point && !entry->on_model) entry->on_model = with_plane(mesh, entry->slide, slides.size());
    slides.push_back(is_point ? *entry->on_model : entry->slide);
  }
  return slides;
}

std::vector<std::uint64_t> SlideList::ids() const {
  std::vector<std::uint64_t> ids;
  ids.reserve(entries_.size());
  for (const auto& entry : entries_) ids.push_back(entry->id);
  return ids;
}

void SlideList::reserve_ids_below(std::uint64_t next_id) noexcept { next_id_ = std::max(next_id_, next_id); }

void SlideList::settle(const std::vector<Ellipse>& ellipses) noexcept {
  for (std::size_t k = 0; k < entries_.size(); ++k) {
    entries_[k]->status = CGW_OK;
    entries_[k]->message.clear();
    if (k < ellipses.size()) entries_[k]->ellipse = ellipses[k];
  }
}

void SlideList::blame(std::span<const AbiError> errors) noexcept {
  for (const auto& entry : entries_) {
    if (entry->status < 0) {
      entry->status = CGW_SLIDE_UNSOLVED;
      entry->message.clear();
    }
    const auto error = std::ranges::find_if(
        errors, [&](const AbiError& it) { return entry->id == it.info().slide || entry->id == it.info().other_slide; });
    if (error == errors.end()) continue;
    entry->status = error->info().code;
    try {
      entry->message = error->what();
    } catch (const std::bad_alloc&) {
      entry->message.clear();  // last_error has the sentence
    }
  }
}

void SlideList::forget_model() noexcept {
  for (const auto& entry : entries_) {
    entry->status = CGW_SLIDE_UNSOLVED;
    entry->message.clear();
    const SlideDefinition& definition = entry->slide.definition;
    if (std::holds_alternative<PointNormalDefinition>(definition) ||
        std::holds_alternative<PointDefinition>(definition))
      entry->ellipse.reset();
    entry->on_model.reset();
  }
}

}  // namespace cagewright::plugin
