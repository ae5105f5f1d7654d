// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_FILE_GLTF_CHECK_H
#define CAGEWRIGHT_HOST_FILE_GLTF_CHECK_H

#include <filesystem>

#include "host/file/gltf_json.h"

namespace cagewright::host {

// Checks what we read of a glTF 2.0 file: scenes, nodes, meshes, accessors, buffer views, buffers, and what skins and
// animations say of nodes. Types, numbers that have to be whole, not negative or finite, indices, and that views lie in
// their buffers. Throws FileError that names the item and the key. What is not ours to read is not looked at.
// O(size of the JSON).
void check_gltf(const std::filesystem::path& path, const GltfJson& json);

}  // namespace cagewright::host

#endif
