// SPDX-License-Identifier: BSD-3-Clause
#include "plugin/src/names.h"

#include <algorithm>
#include <iterator>
#include <optional>

namespace cagewright::plugin {

namespace {

struct Status {
  cgw_status number;
  const char* name;
  std::optional<ErrorCode> code = std::nullopt;  // of the core
};

constexpr Status statuses[] = {
    {CGW_OK, "ok"},
    {CGW_CANCELLED, "cancelled", ErrorCode::cancelled},
    {CGW_SLIDE_UNSOLVED, "unsolved"},
    {CGW_ERROR_INTERNAL, "internal", ErrorCode::internal},
    {CGW_ERROR_INVALID_ARGUMENT, "invalid_argument"},
    {CGW_ERROR_OUT_OF_MEMORY, "out_of_memory"},
    {CGW_ERROR_BUFFER_TOO_SMALL, "buffer_too_small"},
    {CGW_ERROR_NOT_READY, "not_ready"},
    {CGW_ERROR_UNKNOWN_SLIDE, "unknown_slide"},
    {CGW_ERROR_UNKNOWN_PARAMETER, "unknown_parameter"},
    {CGW_ERROR_PARAMETER_OUT_OF_RANGE, "parameter_out_of_range"},
    {CGW_ERROR_STREAM, "stream"},
    {CGW_ERROR_MESH_EMPTY, "mesh_empty", ErrorCode::mesh_empty},
    {CGW_ERROR_MESH_NOT_FINITE, "mesh_not_finite", ErrorCode::mesh_not_finite},
    {CGW_ERROR_MESH_INDEX, "mesh_index", ErrorCode::mesh_index},
    {CGW_ERROR_MESH_OPEN, "mesh_open", ErrorCode::mesh_open},
    {CGW_ERROR_MESH_NON_MANIFOLD, "mesh_non_manifold", ErrorCode::mesh_non_manifold},
    {CGW_ERROR_MESH_NOT_ORIENTABLE, "mesh_not_orientable", ErrorCode::mesh_not_orientable},
    {CGW_ERROR_STROKE_TOO_SHORT, "stroke_too_short", ErrorCode::stroke_too_short},
    {CGW_ERROR_STROKE_COLLINEAR, "stroke_collinear", ErrorCode::stroke_collinear},
    {CGW_ERROR_STROKE_NO_ELLIPSE, "stroke_no_ellipse", ErrorCode::stroke_no_ellipse},
    {CGW_ERROR_SLIDE_NOT_FINITE, "slide_not_finite", ErrorCode::slide_not_finite},
    {CGW_ERROR_SLIDE_DEGENERATE, "slide_degenerate", ErrorCode::slide_degenerate},
    {CGW_ERROR_SLIDE_MISSES_MODEL, "slide_misses_model", ErrorCode::slide_misses_model},
    {CGW_ERROR_SLIDE_NOT_ENCLOSED, "slide_not_enclosed", ErrorCode::slide_not_enclosed},
    {CGW_ERROR_SLIDE_NAME, "slide_name"},
    {CGW_ERROR_SLIDES_TOUCH, "slides_touch", ErrorCode::slides_touch},
    {CGW_ERROR_PART_SEES_SLIDE_TWICE, "part_sees_slide_twice", ErrorCode::part_sees_slide_twice},
    {CGW_ERROR_SECTIONS_OVERLAP, "sections_overlap", ErrorCode::sections_overlap},
    {CGW_ERROR_PARTS_SHARE_WALL, "parts_share_wall", ErrorCode::parts_share_wall},
    {CGW_ERROR_REFINE_DIVERGED, "refine_diverged", ErrorCode::refine_diverged},
    {CGW_ERROR_STATE_MAGIC, "state_magic"},
    {CGW_ERROR_STATE_VERSION, "state_version"},
    {CGW_ERROR_STATE_CORRUPT, "state_corrupt"},
    {CGW_ERROR_STATE_FINGERPRINT, "state_fingerprint"},
};

constexpr auto find_code(ErrorCode code) {
  return std::ranges::find_if(statuses, [code](const Status& s) { return s.code == code; });
}

constexpr bool every_code_has_a_status() {
  for (int code = 0; code <= static_cast<int>(ErrorCode::refine_diverged); ++code) {
    if (find_code(static_cast<ErrorCode>(code)) == std::end(statuses)) return false;
  }
  return true;
}
static_assert(every_code_has_a_status());

}  // namespace

const char* status_name(cgw_status status) noexcept {
  const auto found = std::ranges::find(statuses, status, &Status::number);
  return found == std::end(statuses) ? "unknown" : found->name;
}

cgw_status status_of(ErrorCode code) noexcept {
  const auto found = find_code(code);
  return found == std::end(statuses) ? CGW_ERROR_INTERNAL : found->number;
}

const char* stage_name(std::int32_t stage) noexcept {
  switch (stage) {
    case CGW_STAGE_SEGMENT:
      return "segment";
    case CGW_STAGE_ORIENT:
      return "orient";
    case CGW_STAGE_MESHING:
      return "meshing";
    case CGW_STAGE_REFINE:
      return "refine";
    case CGW_STAGE_ENCLOSE:
      return "enclose";
    default:
      return "unknown";
  }
}

}  // namespace cagewright::plugin
