// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_TESTS_SCENE_SCENE_FILES_H
#define CAGEWRIGHT_HOST_TESTS_SCENE_SCENE_FILES_H

#include <filesystem>
#include <string>
#include <vector>

#include "host/scene/scene_document.h"

namespace cagewright::host::test {

// The .glb and .gltf files of our own scenes that are not broken, and those under the folders of
// CAGEWRIGHT_SCENE_FOLDERS (a list with ';'), sorted.
std::vector<std::filesystem::path> own_scenes();
std::vector<std::filesystem::path> foreign_scenes();

Slide::Ellipse some_ellipse(unsigned seed);
// A tetrahedron with sections that name `slides`.
SceneCage some_cage(int mesh_node, const std::vector<std::int64_t>& slides, unsigned seed);

// Two slides under every mesh node, and a cage round it, by commands.
void add_slides_and_cages(SceneDocument& document);
void remove_all_of_ours(SceneDocument& document);

// The JSON and what follows it.
std::string json_text(const std::filesystem::path& path, const std::string& bytes);
std::string chunks(const std::filesystem::path& path, const std::string& bytes);

}  // namespace cagewright::host::test

#endif
