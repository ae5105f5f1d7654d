// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_FILE_GLTF_URI_H
#define CAGEWRIGHT_HOST_FILE_GLTF_URI_H

#include <filesystem>
#include <optional>
#include <string_view>

namespace cagewright::host {

bool is_data_uri(std::string_view uri);
// The base64 of a data URI of whatever media type; empty where there is none.
std::optional<std::string_view> base64_of(std::string_view uri);

// The file that a URI of a glTF file names, relative to the folder of that file: percent-decoded (RFC 3986, 2.1: %20
// for a blank). Empty for absolute paths and for what is elsewhere ("https://...").
std::optional<std::filesystem::path> relative_path(std::string_view uri);

}  // namespace cagewright::host

#endif
