// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_FILE_GLTF_CONTAINER_H
#define CAGEWRIGHT_HOST_FILE_GLTF_CONTAINER_H

#include <filesystem>
#include <string>
#include <string_view>

#include "host/file/gltf_json.h"

namespace cagewright::host {

// A .glb or .gltf as its JSON and what follows it. Views of the bytes that were split.
struct GltfContainer {
  bool is_binary = false;
  std::string_view json;
  std::string_view chunks;    // binary: every chunk after the JSON, with its header
  std::string_view binary;    // what the first of them holds where it is the binary chunk; else data() is null
  std::string_view trailing;  // binary: what comes after the length that the header says; nobody's, and kept
};

// The JSON of a container, with places in the file where it is binary. Throws FileError.
GltfJson parse_container_json(const std::filesystem::path& path, const GltfContainer& container);

// Throws FileError: empty, cut short, of another version than 2, chunk lengths that are no multiples of 4 or reach
// beyond the file, a first chunk that is not JSON. A file that does not begin with "glTF" is all JSON; of a
// .glb it has to be a JSON object at least.
GltfContainer split_gltf(const std::filesystem::path& path, std::string_view bytes);

// The file with other JSON. Throws FileError where it would be longer than 4 GiB.
std::string join_gltf(const std::filesystem::path& path, const GltfContainer& container, std::string json);

// The binary chunk that holds these bytes, with its header; nothing for none.
std::string binary_chunk(const std::string& bytes);

}  // namespace cagewright::host

#endif
