// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_FILE_STRICT_JSON_H
#define CAGEWRIGHT_HOST_FILE_STRICT_JSON_H

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string_view>

namespace cagewright::host {

// JSON without what nlohmann's parser lets pass: keys that an object has twice. Throws FileError with line and column;
// for a number that no double can hold, also with the keys that lead to it. Include in .cpp files only.
nlohmann::json parse_strict_json(const std::filesystem::path& path, std::string_view text);

}  // namespace cagewright::host

#endif
