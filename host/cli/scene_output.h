// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_CLI_SCENE_OUTPUT_H
#define CAGEWRIGHT_HOST_CLI_SCENE_OUTPUT_H

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "host/cli/cage_input.h"
#include "host/cli/cage_solve.h"

namespace cagewright::host {

using OutputFile = std::pair<std::filesystem::path, std::string>;

// The scene with the slides (unless they are the scene's own) and the cages, through commands: the file `out`, and the
// files that it names and that are not beside it yet. Without a scene in the input a new one holds the model. Throws
// FileError, InputError.
std::vector<OutputFile> scene_files(const CageInput& input, const std::vector<SolvedCage>& solved, const Plugin& plugin,
                                    const std::filesystem::path& out);

// The scene as it is now, for the same purpose.
std::vector<OutputFile> scene_files(const SceneDocument& scene, const std::filesystem::path& out);

}  // namespace cagewright::host

#endif
