// SPDX-License-Identifier: BSD-3-Clause
#include "plugin/src/barrier.h"

#include <algorithm>
#include <cstring>
#include <new>
#include <optional>

#include "plugin/src/names.h"

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

Call::Call(std::atomic<bool>& busy) : busy_(busy) {
  if (busy_.exchange(true)) {
    throw AbiError(CGW_ERROR_INVALID_ARGUMENT,
                   "the session is in another call; do not call it from its own log, progress or stream function, nor "
                   "from two threads at once");
  }
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
