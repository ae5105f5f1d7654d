// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "cagewright/cagewright.h"
#include "core/mesh/half_edge_mesh.h"
#include "core/slide/slide.h"
#include "plugin/src/barrier.h"

namespace cagewright::plugin {

// A slide with what is known of it.
struct SlideEntry {
  std::uint64_t id = 0;
  Slide slide;
  std::optional<Ellipse> ellipse;          // strokes and ellipses: always; by a point: after a solve
  std::optional<Slide> on_model;           // of a point alone: with the plane that the session's model has there
  cgw_status status = CGW_SLIDE_UNSOLVED;  // as in cgw_slide_info
  std::string message;                     // "" or the sentence of the error that blames it
};

// The slides of a session in the order in which they were added. Where a call throws, the list stays as it was.
class SlideList {
 public:
  // Checks what needs no model. Returns the id. Throws AbiError: SLIDE_NAME (other_slide has it), STROKE_*,
  // SLIDE_NOT_FINITE, SLIDE_DEGENERATE. O(points + slides).
  std::uint64_t add(Slide slide);
  // The same with an id of the caller's, for saved states. Throws AbiError(SLIDE_NAME) where the id is taken, too.
  void add_as(std::uint64_t id, Slide slide);
  // The id and the place in the order stay. Throws as add, and AbiError(UNKNOWN_SLIDE).
  void change(std::uint64_t id, Slide slide);
  // Throws AbiError(UNKNOWN_SLIDE).
  void remove(std::uint64_t id);

  std::size_t size() const { return entries_.size(); }
  // Its strings stay where they are until that slide is changed or removed. Precondition: index < size().
  const SlideEntry& at(std::size_t index) const { return *entries_[index]; }
  // As they are to be cut: a point alone has its plane, which is found once for each model. Throws Error, of
  // with_plane.
  std::vector<Slide> on_model(const HalfEdgeMesh& mesh);
  std::vector<std::uint64_t> ids() const;

  // No id below this one is ever given to a new slide.
  std::uint64_t next_id() const { return next_id_; }
  void reserve_ids_below(std::uint64_t next_id) noexcept;

  // A solve succeeded with these ellipses, one a slide: every slide is CGW_OK.
  void settle(const std::vector<Ellipse>& ellipses) noexcept;
  // A solve failed: the slides that `errors` name carry them, the first where there are several; older blame goes.
  void blame(std::span<const AbiError> errors) noexcept;
  // There is another model: nothing is known of it.
  void forget_model() noexcept;

 private:
  std::size_t index_of(std::uint64_t id) const;
  // Throws what makes the slide unusable; `id` is for the error.
  std::unique_ptr<SlideEntry> checked(Slide slide, std::uint64_t id, std::uint64_t id_in_errors) const;

  std::vector<std::unique_ptr<SlideEntry>> entries_;
  std::uint64_t next_id_ = 1;
};

}  // namespace cagewright::plugin
