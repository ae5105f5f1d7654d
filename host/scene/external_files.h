// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_SCENE_EXTERNAL_FILES_H
#define CAGEWRIGHT_HOST_SCENE_EXTERNAL_FILES_H

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "host/scene/scene_document.h"

namespace cagewright::host {

// The buffers and images that the scene names by relative paths inside its folder, for a copy of it at `out` in another
// folder: which files have to be written, and their bytes. None where the folder is the same, for those that are there
// already with the same bytes, and for those that the scene itself misses. Throws FileError where another file has such
// a name, which would be overwritten.
std::vector<std::pair<std::filesystem::path, std::string>> external_copies(const SceneDocument& scene,
                                                                           const std::filesystem::path& out);

// Files that the scene names and that such a copy would miss: outside its folder, or not there. A sentence each.
std::vector<std::string> missed_files(const SceneDocument& scene, const std::filesystem::path& out);

}  // namespace cagewright::host

#endif
