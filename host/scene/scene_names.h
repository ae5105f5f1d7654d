// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_SCENE_SCENE_NAMES_H
#define CAGEWRIGHT_HOST_SCENE_SCENE_NAMES_H

#include <filesystem>

namespace cagewright::host {

// Whether a file is written as a scene: .glb or .gltf, in any case.
bool is_scene_name(const std::filesystem::path& path);
bool is_binary_scene_name(const std::filesystem::path& path);  // .glb

}  // namespace cagewright::host

#endif
