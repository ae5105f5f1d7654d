// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_FILE_GLTF_BUFFERS_H
#define CAGEWRIGHT_HOST_FILE_GLTF_BUFFERS_H

#include <filesystem>
#include <vector>

#include "host/file/gltf_container.h"
#include "host/file/gltf_json.h"

namespace cagewright::host {

// The bytes of every buffer, as many as its byteLength says: of the binary chunk, of data URIs, and of files that are
// named relative to the folder of `path`. Throws FileError, which names the buffer. Precondition: check_gltf has
// passed. O(bytes).
std::vector<std::vector<unsigned char>> read_gltf_buffers(const std::filesystem::path& path,
                                                          const GltfContainer& container, const GltfJson& json);

}  // namespace cagewright::host

#endif
