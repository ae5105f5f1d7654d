// SPDX-License-Identifier: BSD-3-Clause
#include "host/scene/scene_names.h"

#include "host/file/file_bytes.h"

namespace cagewright::host {

bool is_scene_name(const std::filesystem::path& path) {
  const std::string ending = lower_ending(path);
  return ending == ".glb" || ending == ".gltf";
}

bool is_binary_scene_name(const std::filesystem::path& path) { return lower_ending(path) == ".glb"; }

}  // namespace cagewright::host
