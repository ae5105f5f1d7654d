// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_SCENE_DETACH_NODES_H
#define CAGEWRIGHT_HOST_SCENE_DETACH_NODES_H

#include <vector>

#include "host/scene/scene_parts.h"

namespace cagewright::host {

// Whether a slide's or a cage's node has children, or holds what we do not give it: a camera, a skin, extensions and
// extras of others.
bool has_content_of_others(const GltfJson& node, bool is_cage);

// Takes the nodes of the content's slides and cages out of the base, and our extensions out of those that are pinned
// and of extensionsUsed; sets their homes. The nodes are given in the content's order. O(size of the nodes).
void detach_nodes(SceneBase& base, SceneContent& content, const std::vector<int>& slide_nodes,
                  const std::vector<int>& cage_nodes);

}  // namespace cagewright::host

#endif
