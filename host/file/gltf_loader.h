// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_FILE_GLTF_LOADER_H
#define CAGEWRIGHT_HOST_FILE_GLTF_LOADER_H

#include <filesystem>
#include <string_view>

namespace tinygltf {
class Model;
}

namespace cagewright::host {

// The document of a .gltf or .glb with its buffers; images are not loaded. Buffers are looked for beside `path` and
// nowhere else. Throws FileError.
void load_gltf(const std::filesystem::path& path, std::string_view bytes, tinygltf::Model& model);

}  // namespace cagewright::host

#endif
