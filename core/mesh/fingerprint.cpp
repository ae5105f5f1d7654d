// SPDX-License-Identifier: BSD-3-Clause
// FNV-1a over words of 8 bytes instead of bytes. The shift carries high bits down, which a product alone never does.
#include "core/mesh/fingerprint.h"

#include <algorithm>
#include <cstddef>
#include <cstring>

namespace cagewright {
namespace {

std::uint64_t mix(std::uint64_t hash, std::uint64_t word) {
  hash = (hash ^ word) * 0x00000100000001B3u;
  return hash ^ (hash >> 32);
}

std::uint64_t mix(std::uint64_t hash, const void* data, std::size_t bytes) {
  const auto* byte = static_cast<const unsigned char*>(data);
  for (std::size_t at = 0; at < bytes; at += sizeof(std::uint64_t)) {
    std::uint64_t word = 0;
    std::memcpy(&word, byte + at, std::min(sizeof word, bytes - at));
    hash = mix(hash, word);
  }
  return hash;
}

template <class Matrix>
std::uint64_t mix_rows(std::uint64_t hash, const Matrix& rows) {
  hash = mix(hash, static_cast<std::uint64_t>(rows.rows()));
  return mix(hash, rows.data(), static_cast<std::size_t>(rows.size()) * sizeof(typename Matrix::Scalar));
}

}  // namespace

std::uint64_t fingerprint(const IndexedMesh& mesh) {
  return mix_rows(mix_rows(0xCBF29CE484222325u, mesh.points), mesh.triangles);
}

}  // namespace cagewright
