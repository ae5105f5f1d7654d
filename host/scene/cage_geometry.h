// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_SCENE_CAGE_GEOMETRY_H
#define CAGEWRIGHT_HOST_SCENE_CAGE_GEOMETRY_H

#include <filesystem>

#include "host/scene/scene_parts.h"

// The mesh, accessors, buffer views and buffer of a cage in a glTF file.
namespace cagewright::host {

// Finds which of it is used by the content's cages and strays alone and takes it out of the base where nothing of
// others comes after it; else notes its place. Sets block, mesh and geometry of each as_read. O(accessors).
void detach_cage_geometry(SceneBase& base, SceneContent& content);

// The numbers of their meshes, in the content's order; -1 for a stray without one.
struct CageMeshes {
  std::vector<int> cages, strays;
};

// Puts the geometry of cages and strays into json, the base's: as it was read, or made of a cage's mesh where that is
// new, with the old one's material. Adds to `filled` the JSON pointers of arrays that were there and empty. Throws
// FileError where a cage is too far out for glTF's floats.
CageMeshes attach_cage_geometry(const std::filesystem::path& path, const SceneBase& base, const SceneContent& content,
                                const std::vector<bool>& is_new, GltfJson& json, std::set<std::string>& filled);

}  // namespace cagewright::host

#endif
