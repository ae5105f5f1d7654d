// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_FILE_GLTF_LOADER_H
#define CAGEWRIGHT_HOST_FILE_GLTF_LOADER_H

#include <filesystem>
#include <string_view>

#include "host/file/gltf_container.h"
#include "host/file/gltf_json.h"

namespace tinygltf {
class Model;
}

namespace cagewright::host {

// The typed view of a .gltf or .glb: scenes, nodes, meshes, accessors, buffer views and buffers; nothing else is looked
// at, and of extensions and extras only ours and Draco's are there, empty. Throws FileError.
void load_gltf(const std::filesystem::path& path, std::string_view bytes, tinygltf::Model& model);

// The same of a file that is split and parsed already.
void load_gltf(const std::filesystem::path& path, const GltfContainer& container, const GltfJson& json,
               tinygltf::Model& model);

}  // namespace cagewright::host

#endif
