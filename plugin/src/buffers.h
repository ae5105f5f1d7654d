// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "core/mesh/types.h"
#include "plugin/src/barrier.h"

// The host's buffers that results are copied to. One that is NULL is not wanted.
namespace cagewright::plugin {

[[noreturn]] inline void not_ready(const std::string& what) {
  throw AbiError(CGW_ERROR_NOT_READY, "there is no " + what + " yet; solve up to the stage that makes it");
}

// Throws AbiError(INVALID_ARGUMENT).
inline void check_index(std::uint64_t index, std::uint64_t count, const char* what) {
  if (index >= count) {
    throw AbiError(CGW_ERROR_INVALID_ARGUMENT, "there is no " + std::string(what) + " at index " +
                                                   std::to_string(index) + "; the last solve made " +
                                                   std::to_string(count));
  }
}

// Throws AbiError(BUFFER_TOO_SMALL).
inline void check_room(const void* buffer, std::uint64_t capacity, std::uint64_t count, const char* what) {
  if (buffer && capacity < count) {
    throw AbiError(CGW_ERROR_BUFFER_TOO_SMALL,
                   "the buffer of the " + std::string(what) + " has room for " + std::to_string(capacity) +
                       " rows, but there are " + std::to_string(count) + "; call with NULL pointers to get the counts");
  }
}

template <class Matrix, class To>
void copy_rows(const Matrix& from, To* to) {
  if (!to) return;
  static_assert(Matrix::IsRowMajor);
  std::transform(from.data(), from.data() + from.size(), to, [](auto value) { return static_cast<To>(value); });
}

template <class From, class To>
void copy_list(const std::vector<From>& from, To* to) {
  if (to) std::transform(from.begin(), from.end(), to, [](From value) { return static_cast<To>(value); });
}

template <class Pair, class To>
void copy_pairs(const std::vector<Pair>& from, To* to) {
  if (!to) return;
  for (const auto& [first, second] : from) {
    *to++ = static_cast<To>(first);
    *to++ = static_cast<To>(second);
  }
}

inline void copy_vector(const Vector3& from, double* to) { std::copy_n(from.data(), 3, to); }

}  // namespace cagewright::plugin
