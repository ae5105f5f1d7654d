// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>
#include <type_traits>

#include "plugin/src/barrier.h"

// Structs that cross the ABI: the caller may know a shorter or a longer one than this plug-in.
namespace cagewright::plugin {

// The bytes of *given that both sides know, in whole fields. Throws AbiError(INVALID_ARGUMENT) where `given` is NULL or
// its struct_size does not even hold the first two fields. `name` is the type's, for the sentence.
template <class T>
std::size_t common_size(const T* given, const char* name) {
  static_assert(std::is_trivially_copyable_v<T>);
  constexpr std::size_t first_two_fields = 2 * sizeof(std::uint32_t);
  if (!given) throw AbiError(CGW_ERROR_INVALID_ARGUMENT, std::string("the pointer to ") + name + " is NULL");
  if (given->struct_size < first_two_fields) {
    throw AbiError(CGW_ERROR_INVALID_ARGUMENT, std::string("struct_size of ") + name + " is " +
                                                   std::to_string(given->struct_size) + ", but has to be at least " +
                                                   std::to_string(first_two_fields) + "; set it to sizeof(" + name +
                                                   ")");
  }
  // A size that ends inside a field tears it: half a pointer is worse than none.
  return std::min<std::size_t>(given->struct_size, sizeof(T)) / alignof(T) * alignof(T);
}

// *given with `defaults` where the caller's struct ends too early. Throws as common_size.
template <class T>
T read_struct(const T* given, const T& defaults, const char* name) {
  T value = defaults;
  std::memcpy(&value, given, common_size(given, name));
  return value;
}

// Writes what the caller has room for; keeps the caller's struct_size. Throws as common_size.
template <class T>
void write_struct(T* out, T value, const char* name) {
  const std::size_t size = common_size(out, name);
  value.struct_size = out->struct_size;
  std::memcpy(out, &value, size);
}

}  // namespace cagewright::plugin
