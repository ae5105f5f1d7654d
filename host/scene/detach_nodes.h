// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_SCENE_DETACH_NODES_H
#define CAGEWRIGHT_HOST_SCENE_DETACH_NODES_H

#include <vector>

#include "host/scene/scene_parts.h"

namespace cagewright::host {

// Whether a slide's or a cage's node has children, or holds what we do not give it: a camera, a skin, extensions and
// extras of others.
bool has_content_of_others(const GltfJson& node, bool is_cage);

// The nodes of the content's slides, cages and strays, in its order.
struct OwnNodes {
  std::vector<int> slides, cages, strays;
};

// Takes them out of the base, and our extensions out of those that are pinned and of extensionsRequired; sets their
// homes. O(size of the nodes).
void detach_nodes(SceneBase& base, SceneContent& content, const OwnNodes& own);

}  // namespace cagewright::host

#endif
