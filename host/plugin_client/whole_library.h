// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_PLUGIN_CLIENT_WHOLE_LIBRARY_H
#define CAGEWRIGHT_HOST_PLUGIN_CLIENT_WHOLE_LIBRARY_H

#include <cstdint>
#include <filesystem>
#include <optional>

namespace cagewright::host {

// How many bytes the ELF file of a 64-bit shared library has to have for what the system's loader maps of it; nothing
// where it is no such file. The loader maps a file that is cut short as it maps a whole one, and the program ends with
// SIGBUS where it reads what is not there.
std::optional<std::uint64_t> bytes_of_whole_library(const std::filesystem::path& path);

}  // namespace cagewright::host

#endif
