// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_SCENE_SCENE_JSON_H
#define CAGEWRIGHT_HOST_SCENE_SCENE_JSON_H

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace cagewright::host {

// JSON that loses nothing: keys in their order, and a number that a double or a 64-bit integer would not write in the
// same way is kept as its text (as a binary value, which JSON itself cannot hold). Include in .cpp files where
// possible.
using SceneJson = nlohmann::ordered_json;

// Throws FileError with line and column where `text` is not JSON, is nested deeper than 256 levels, has a key twice in
// one object, or a number that no double can hold.
SceneJson parse_scene_json(const std::filesystem::path& path, std::string_view text);

// The text that parses to the same value, number for number; on one line where indent < 0.
std::string scene_json_text(const SceneJson& json, int indent = -1);

// A finite number, however it is kept; empty where it is none.
std::optional<double> number_in(const SceneJson& json);

// The value of a key, or null where `json` is no object or does not have it.
const SceneJson* find_key(const SceneJson& json, std::string_view key);
SceneJson* find_key(SceneJson& json, std::string_view key);

}  // namespace cagewright::host

#endif
