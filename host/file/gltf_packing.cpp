// SPDX-License-Identifier: BSD-3-Clause
#include "host/file/gltf_packing.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "host/file/byte_order.h"
#include "host/file/file_error.h"

namespace cagewright::host {

PackedMesh pack_mesh(const std::filesystem::path& path, const TriangleMesh& mesh) {
  PackedMesh packed;
  packed.least.fill(std::numeric_limits<double>::infinity());
  packed.most.fill(-std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    if (!(std::abs(mesh.points[i]) <= double{std::numeric_limits<float>::max()})) {
      throw FileError(path, {},
                      "cannot be written: vertex " + std::to_string(i / 3) + " is too far out for glTF's floats");
    }
    const auto x = static_cast<float>(mesh.points[i]);
    append_little_endian(packed.bytes, x);
    packed.least[i % 3] = std::min(packed.least[i % 3], double{x});
    packed.most[i % 3] = std::max(packed.most[i % 3], double{x});
  }
  packed.position_bytes = packed.bytes.size();
  // 65535 is the restart value of 16-bit indices and not allowed.
  if (mesh.vertex_count() <= 65535) packed.index_type = gltf_unsigned_short;
  for (const std::uint32_t index : mesh.triangles) {
    if (packed.index_type == gltf_unsigned_short) {
      append_little_endian(packed.bytes, static_cast<std::uint16_t>(index));
    } else {
      append_little_endian(packed.bytes, index);
    }
  }
  packed.index_bytes = packed.bytes.size() - packed.position_bytes;
  packed.bytes.resize((packed.bytes.size() + 3) / 4 * 4, '\0');
  return packed;
}

}  // namespace cagewright::host
