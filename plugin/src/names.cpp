// SPDX-License-Identifier: BSD-3-Clause
#include "plugin/src/names.h"

namespace cagewright::plugin {

const char* status_name(cgw_status status) noexcept {
  switch (status) {
    case CGW_OK:
      return "ok";
    case CGW_CANCELLED:
      return "cancelled";
    case CGW_ERROR_INTERNAL:
      return "internal";
    case CGW_ERROR_INVALID_ARGUMENT:
      return "invalid_argument";
    case CGW_ERROR_OUT_OF_MEMORY:
      return "out_of_memory";
    case CGW_ERROR_BUFFER_TOO_SMALL:
      return "buffer_too_small";
    case CGW_ERROR_NOT_READY:
      return "not_ready";
    case CGW_ERROR_UNKNOWN_SLIDE:
      return "unknown_slide";
    case CGW_ERROR_UNKNOWN_PARAMETER:
      return "unknown_parameter";
    case CGW_ERROR_PARAMETER_OUT_OF_RANGE:
      return "parameter_out_of_range";
    case CGW_ERROR_STREAM:
      return "stream";
    case CGW_ERROR_MESH_EMPTY:
      return "mesh_empty";
    case CGW_ERROR_MESH_NOT_FINITE:
      return "mesh_not_finite";
    case CGW_ERROR_MESH_INDEX:
      return "mesh_index";
    case CGW_ERROR_MESH_OPEN:
      return "mesh_open";
    case CGW_ERROR_MESH_NON_MANIFOLD:
      return "mesh_non_manifold";
    case CGW_ERROR_MESH_NOT_ORIENTABLE:
      return "mesh_not_orientable";
    case CGW_ERROR_STROKE_TOO_SHORT:
      return "stroke_too_short";
    case CGW_ERROR_STROKE_COLLINEAR:
      return "stroke_collinear";
    case CGW_ERROR_STROKE_NO_ELLIPSE:
      return "stroke_no_ellipse";
    case CGW_ERROR_SLIDE_NOT_FINITE:
      return "slide_not_finite";
    case CGW_ERROR_SLIDE_DEGENERATE:
      return "slide_degenerate";
    case CGW_ERROR_SLIDE_MISSES_MODEL:
      return "slide_misses_model";
    case CGW_ERROR_SLIDE_NOT_ENCLOSED:
      return "slide_not_enclosed";
    case CGW_ERROR_SLIDE_NAME:
      return "slide_name";
    case CGW_ERROR_SLIDES_TOUCH:
      return "slides_touch";
    case CGW_ERROR_PART_SEES_SLIDE_TWICE:
      return "part_sees_slide_twice";
    case CGW_ERROR_SECTIONS_OVERLAP:
      return "sections_overlap";
    case CGW_ERROR_PARTS_SHARE_WALL:
      return "parts_share_wall";
    case CGW_ERROR_REFINE_DIVERGED:
      return "refine_diverged";
    case CGW_ERROR_STATE_MAGIC:
      return "state_magic";
    case CGW_ERROR_STATE_VERSION:
      return "state_version";
    case CGW_ERROR_STATE_CORRUPT:
      return "state_corrupt";
    case CGW_ERROR_STATE_FINGERPRINT:
      return "state_fingerprint";
    default:
      return "unknown";
  }
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
    default:
      return "unknown";
  }
}

}  // namespace cagewright::plugin
