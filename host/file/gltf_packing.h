// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_FILE_GLTF_PACKING_H
#define CAGEWRIGHT_HOST_FILE_GLTF_PACKING_H

#include <array>
#include <filesystem>
#include <string>

#include "host/file/triangle_mesh.h"

namespace cagewright::host {

// glTF's numbers for component types, targets and modes.
inline constexpr int gltf_unsigned_short = 5123, gltf_unsigned_int = 5125, gltf_float = 5126;
inline constexpr int gltf_array_buffer = 34962, gltf_element_array_buffer = 34963, gltf_triangles = 4;

// A mesh as one glTF buffer: positions as floats, then indices as short as they can be, padded to four bytes.
struct PackedMesh {
  std::string bytes;
  std::size_t position_bytes = 0, index_bytes = 0;
  int index_type = gltf_unsigned_int;
  std::array<double, 3> least{}, most{};  // of the positions as floats
};

// Throws FileError where a position is beyond a float. O(n).
PackedMesh pack_mesh(const std::filesystem::path& path, const TriangleMesh& mesh);

}  // namespace cagewright::host

#endif
