// SPDX-License-Identifier: BSD-3-Clause
#include "host/scene/mesh_fingerprint.h"

#include <bit>
#include <cstdint>
#include <cstdio>

namespace cagewright::host {

std::string mesh_fingerprint(const TriangleMesh& mesh) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  const auto add = [&hash](std::uint32_t word) {
    for (int byte = 0; byte < 4; ++byte) {
      hash = (hash ^ (word >> (8 * byte) & 0xffu)) * 0x100000001b3u;
    }
  };
  for (const double value : mesh.points) add(std::bit_cast<std::uint32_t>(static_cast<float>(value + 0.0)));  // no -0
  for (const std::uint32_t corner : mesh.triangles) add(corner);
  char text[17];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
  return text;
}

}  // namespace cagewright::host
