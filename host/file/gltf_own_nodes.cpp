// SPDX-License-Identifier: BSD-3-Clause
#include "host/file/gltf_own_nodes.h"

#include <tiny_gltf.h>

namespace cagewright::host {
namespace {

bool is_named(const tinygltf::Node& node, const char* name) {
  return node.extensions.count(name) > 0 || (node.extras.IsObject() && node.extras.Has(name));
}

}  // namespace

bool is_slide_node(const tinygltf::Node& node) { return is_named(node, slide_extension); }

bool is_cage_node(const tinygltf::Node& node) { return node.mesh >= 0 && is_named(node, cage_extension); }

bool is_empty_cage_node(const tinygltf::Node& node) { return node.mesh < 0 && is_named(node, cage_extension); }

bool shows_model(const tinygltf::Node& node) { return node.mesh >= 0 && !is_cage_node(node); }

}  // namespace cagewright::host
