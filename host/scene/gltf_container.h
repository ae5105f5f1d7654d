// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_SCENE_GLTF_CONTAINER_H
#define CAGEWRIGHT_HOST_SCENE_GLTF_CONTAINER_H

#include <filesystem>
#include <string>
#include <string_view>

namespace cagewright::host {

// A .glb or .gltf as its JSON and what follows it. Views of the bytes that were split.
struct GltfContainer {
  bool is_binary = false;
  std::string_view json;
  std::string_view chunks;    // binary: every chunk after the JSON, with its header
  std::string_view trailing;  // binary: what comes after the length that the header says; nobody's, and kept
};

// Throws FileError: cut short, of another version than 2, chunk lengths that are no multiples of 4 or reach beyond the
// file, a first chunk that is not JSON. A file that does not begin with "glTF" is all JSON.
GltfContainer split_gltf(const std::filesystem::path& path, std::string_view bytes);

// The file with other JSON. Throws FileError where it would be longer than 4 GiB.
std::string join_gltf(const std::filesystem::path& path, const GltfContainer& container, std::string json);

}  // namespace cagewright::host

#endif
