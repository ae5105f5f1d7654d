// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_TESTS_MODELS_ORACLE_H
#define CAGEWRIGHT_HOST_TESTS_MODELS_ORACLE_H

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace cagewright::host {

// An independent judge of cages, a program `ORACLE MODEL CAGE` that prints one JSON object.

// Why there is none; nothing where there is.
std::optional<std::string> why_no_oracle();

// Throws std::runtime_error where it fails.
nlohmann::json ask_oracle(const std::filesystem::path& model, const std::filesystem::path& cage);

}  // namespace cagewright::host

#endif
