// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_SCENE_OUTLINE_H
#define CAGEWRIGHT_HOST_SCENE_OUTLINE_H

#include <filesystem>
#include <string>
#include <vector>

#include "host/scene/scene_document.h"

namespace tinygltf {
class Model;
class Node;
}  // namespace tinygltf

namespace cagewright::host {

// A node's name, or else its mesh's; may be empty.
std::string shown_name(const tinygltf::Model& model, const tinygltf::Node& node);

// The tree of a scene, as SceneDocument::nodes says. `model` is the file, `content` what is ours in it now. Throws
// FileError where nodes form no tree. O(nodes).
std::vector<SceneNode> outline(const std::filesystem::path& path, const tinygltf::Model& model,
                               const SceneContent& content);

}  // namespace cagewright::host

#endif
