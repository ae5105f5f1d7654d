// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_APP_PUT_ASIDE_H
#define CAGEWRIGHT_HOST_APP_PUT_ASIDE_H

#include <filesystem>

namespace cagewright::host {

// Where put_aside would leave what was not saved of a scene: NAME_recovered_1.glb beside it, or the next number that is
// free.
std::filesystem::path free_name_aside(const std::filesystem::path& scene);

// Gives `file`, which has what was not saved of a scene, such a name and returns it. No other file is replaced, also
// where others do the same at the same time. Throws std::filesystem::filesystem_error, and the file is where it was.
std::filesystem::path put_aside(const std::filesystem::path& file, const std::filesystem::path& scene);

}  // namespace cagewright::host

#endif
