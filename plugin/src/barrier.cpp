// SPDX-License-Identifier: BSD-3-Clause
#include "plugin/src/barrier.h"

#include <algorithm>
#include <cstring>
#include <new>
#include <optional>

namespace cagewright::plugin {

namespace {

cgw_error_info info_with(cgw_status code) {
  cgw_error_info info = CGW_ERROR_INFO_INIT;
  info.code = code;
  return info;
}

std::uint64_t id_of(const std::optional<std::size_t>& slide, std::span<const std::uint64_t> ids) {
  return slide && *slide < ids.size() ? ids[*slide] : CGW_NO_ID;
}

constexpr bool continues_utf8(char c) { return (static_cast<unsigned char>(c) & 0xC0u) == 0x80u; }

}  // namespace

AbiError::AbiError(cgw_status code, const std::string& sentence) : AbiError(info_with(code), sentence) {}

AbiError::AbiError(const cgw_error_info& info, const std::string& sentence)
    : std::runtime_error(sentence), info_(info) {}

cgw_status status_of(ErrorCode code) {
  switch (code) {
    case ErrorCode::cancelled:
      return CGW_CANCELLED;
    case ErrorCode::internal:
      return CGW_ERROR_INTERNAL;
    case ErrorCode::mesh_empty:
      return CGW_ERROR_MESH_EMPTY;
    case ErrorCode::mesh_not_finite:
      return CGW_ERROR_MESH_NOT_FINITE;
    case ErrorCode::mesh_index:
      return CGW_ERROR_MESH_INDEX;
    case ErrorCode::mesh_open:
      return CGW_ERROR_MESH_OPEN;
    case ErrorCode::mesh_non_manifold:
      return CGW_ERROR_MESH_NON_MANIFOLD;
    case ErrorCode::mesh_not_orientable:
      return CGW_ERROR_MESH_NOT_ORIENTABLE;
    case ErrorCode::stroke_too_short:
      return CGW_ERROR_STROKE_TOO_SHORT;
    case ErrorCode::stroke_collinear:
      return CGW_ERROR_STROKE_COLLINEAR;
    case ErrorCode::stroke_no_ellipse:
      return CGW_ERROR_STROKE_NO_ELLIPSE;
    case ErrorCode::slide_not_finite:
      return CGW_ERROR_SLIDE_NOT_FINITE;
    case ErrorCode::slide_degenerate:
      return CGW_ERROR_SLIDE_DEGENERATE;
    case ErrorCode::slide_misses_model:
      return CGW_ERROR_SLIDE_MISSES_MODEL;
    case ErrorCode::slide_not_enclosed:
      return CGW_ERROR_SLIDE_NOT_ENCLOSED;
    case ErrorCode::slides_touch:
      return CGW_ERROR_SLIDES_TOUCH;
    case ErrorCode::part_sees_slide_twice:
      return CGW_ERROR_PART_SEES_SLIDE_TWICE;
    case ErrorCode::sections_overlap:
      return CGW_ERROR_SECTIONS_OVERLAP;
    case ErrorCode::parts_share_wall:
      return CGW_ERROR_PARTS_SHARE_WALL;
    case ErrorCode::refine_diverged:
      return CGW_ERROR_REFINE_DIVERGED;
  }
  return CGW_ERROR_INTERNAL;
}

AbiError to_abi_error(const Error& error, std::span<const std::uint64_t> ids) {
  cgw_error_info info = info_with(status_of(error.code()));
  const ErrorPlace& place = error.place();
  info.slide = id_of(place.slide, ids);
  info.other_slide = id_of(place.other_slide, ids);
  if (place.part) info.part = *place.part;
  if (place.element) info.element = *place.element;
  if (place.point) {
    info.has_point = 1;
    std::copy_n(place.point->data(), 3, info.point);
  }
  return AbiError(info, error.what());
}

void LastError::set(const cgw_error_info& what, const char* text) noexcept {
  info = what;
  std::size_t length = std::strlen(text);
  if (length >= sizeof sentence) {
    length = sizeof sentence - 1;
    while (length > 0 && continues_utf8(text[length])) --length;
  }
  std::memcpy(sentence, text, length);
  sentence[length] = '\0';
}

LastError& thread_error() noexcept {
  thread_local LastError error;
  return error;
}

cgw_status keep_exception(LastError& error) noexcept {
  cgw_error_info info = CGW_ERROR_INFO_INIT;
  try {
    throw;
  } catch (const AbiError& thrown) {
    error.set(thrown.info(), thrown.what());
  } catch (const Error& thrown) {
    const AbiError translated = to_abi_error(thrown, {});
    error.set(translated.info(), translated.what());
  } catch (const std::bad_alloc&) {
    info.code = CGW_ERROR_OUT_OF_MEMORY;
    error.set(info, "out of memory; free some, or use a model with fewer triangles");
  } catch (const std::exception& thrown) {
    info.code = CGW_ERROR_INTERNAL;
    error.set(info, thrown.what());
  } catch (...) {
    info.code = CGW_ERROR_INTERNAL;
    error.set(info, "something that is no std::exception was thrown inside the plug-in or by a host function");
  }
  return error.info.code;
}

}  // namespace cagewright::plugin
