// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_FILE_GLTF_JSON_H
#define CAGEWRIGHT_HOST_FILE_GLTF_JSON_H

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace cagewright::host {

// JSON that loses nothing: keys in their order, and a number that a double or a 64-bit integer would not write in the
// same way is kept as its text (as a binary value, which JSON itself cannot hold). Include in .cpp files where
// possible.
using GltfJson = nlohmann::ordered_json;

// Throws FileError where `text` is not JSON, is nested deeper than 256 levels, has a key twice in one object, or a
// number that no double can hold. The place is line and column, or the byte of the file where first_byte says which the
// text begins at.
GltfJson parse_gltf_json(const std::filesystem::path& path, std::string_view text,
                         std::optional<std::size_t> first_byte = {});

// The text that parses to the same value, number for number; on one line where indent < 0.
std::string gltf_json_text(const GltfJson& json, int indent = -1);

// A finite number, however it is kept; empty where it is none.
std::optional<double> number_in(const GltfJson& json);

// An integer, as indices are; empty where it is none or `json` is null.
std::optional<int> index_in(const GltfJson* json);

// The value of a key, or null where `json` is no object or does not have it.
const GltfJson* find_key(const GltfJson& json, std::string_view key);
GltfJson* find_key(GltfJson& json, std::string_view key);

}  // namespace cagewright::host

#endif
