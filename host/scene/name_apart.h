// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_SCENE_NAME_APART_H
#define CAGEWRIGHT_HOST_SCENE_NAME_APART_H

#include <string>
#include <vector>

#include "host/scene/scene_content.h"

namespace cagewright::host {

// Gives slides the ids and names that SceneContent asks for, as copies made by another tool have those of the first:
// the first keeps them, and the cage of a copied mesh node follows its copied slides. Returns a sentence for each slide
// that was renumbered or renamed. O(n log n).
std::vector<std::string> name_apart(SceneContent& content);

}  // namespace cagewright::host

#endif
