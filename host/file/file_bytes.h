// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_FILE_FILE_BYTES_H
#define CAGEWRIGHT_HOST_FILE_FILE_BYTES_H

#include <filesystem>
#include <string>

namespace cagewright::host {

// The whole file. Throws FileError where it is missing, not a regular file, or not readable.
std::string read_bytes(const std::filesystem::path& path);

// The ending in lower case with its dot, ".obj"; "" where there is none.
std::string lower_ending(const std::filesystem::path& path);

}  // namespace cagewright::host

#endif
