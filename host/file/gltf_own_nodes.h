// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_FILE_GLTF_OWN_NODES_H
#define CAGEWRIGHT_HOST_FILE_GLTF_OWN_NODES_H

#include <string_view>

namespace tinygltf {
class Node;
}

namespace cagewright::host {

// The extensions of docs/scene-format.md; the same names are keys of `extras`, for tools that drop extensions.
inline constexpr char slide_extension[] = "CAGEWRIGHT_cut_slide";
inline constexpr char cage_extension[] = "CAGEWRIGHT_cage";
inline bool is_own_extension(std::string_view name) { return name == slide_extension || name == cage_extension; }

// By the extension, or by what `extras` still say. A cage has a mesh.
bool is_slide_node(const tinygltf::Node& node);
bool is_cage_node(const tinygltf::Node& node);
// A cage's node that has lost its mesh.
bool is_empty_cage_node(const tinygltf::Node& node);
// Whether it has a mesh that is no cage.
bool shows_model(const tinygltf::Node& node);

}  // namespace cagewright::host

#endif
