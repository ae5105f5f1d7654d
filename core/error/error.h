// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "core/mesh/types.h"

namespace cagewright {

// What went wrong. The plug-in maps each to one frozen status of the C ABI.
enum class ErrorCode {
  cancelled,
  internal,
  mesh_empty,
  mesh_not_finite,
  mesh_index,
  mesh_open,
  mesh_non_manifold,
  mesh_not_orientable,
  stroke_too_short,
  stroke_collinear,
  stroke_no_ellipse,
  slide_not_finite,
  slide_degenerate,
  slide_misses_model,
  slide_not_enclosed,
  slides_touch,
  part_sees_slide_twice,
  sections_overlap,
  parts_share_wall,
  refine_diverged,
};

// Where it went wrong; what is not known stays empty.
struct ErrorPlace {
  std::optional<std::size_t> slide;        // index into the slides of the call
  std::optional<std::size_t> other_slide;  // the second slide of a pair
  std::optional<std::size_t> part;
  std::optional<std::size_t> element;  // vertex, triangle or stroke point, as the code implies
  std::optional<Vector3> point;        // model units
};

// The one error of the core. what() is a sentence for the user: the culprit and the next step.
class Error : public std::runtime_error {
 public:
  Error(ErrorCode code, const std::string& sentence, ErrorPlace place = {})
      : std::runtime_error(sentence), code_(code), place_(std::move(place)) {}
  ErrorCode code() const { return code_; }
  const ErrorPlace& place() const { return place_; }
  // What else would have failed in the same call, each without others.
  const std::vector<Error>& others() const { return others_; }
  void add_other(Error other) { others_.push_back(std::move(other)); }

 private:
  ErrorCode code_;
  ErrorPlace place_;
  std::vector<Error> others_;
};

// "(1.2, 0.4, 3)": a point as sentences show it, 6 significant digits; what is 0 but for rounding, beside the largest
// coordinate, is 0.
std::string to_text(const Vector3& point);

}  // namespace cagewright
