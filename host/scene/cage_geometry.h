// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_SCENE_CAGE_GEOMETRY_H
#define CAGEWRIGHT_HOST_SCENE_CAGE_GEOMETRY_H

#include <filesystem>

#include "host/scene/scene_parts.h"

// The mesh, accessors, buffer views and buffer of a cage in a glTF file.
namespace cagewright::host {

// Finds which of it is used by the content's cages alone and takes it out of the base where nothing of others comes
// after it; else notes its place. Sets block, mesh and geometry of every cage's as_read. O(accessors).
void detach_cage_geometry(SceneBase& base, SceneContent& content);

// Puts each cage's geometry into json, the base's, and returns of each the number of its mesh. Adds to `filled` the
// JSON pointers of arrays that were there and empty. Throws FileError where a cage is too far out for glTF's floats.
std::vector<int> attach_cage_geometry(const std::filesystem::path& path, const SceneBase& base,
                                      const SceneContent& content, GltfJson& json, std::set<std::string>& filled);

}  // namespace cagewright::host

#endif
