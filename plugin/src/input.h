// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cagewright/cagewright.h"
#include "core/mesh/types.h"
#include "core/slide/slide.h"

// What hosts pass in, as the core wants it. Everything is copied; nothing of the host's is kept.
namespace cagewright::plugin {

// Throws AbiError: INVALID_ARGUMENT (NULL, struct_size, more rows than 2^31 - 1), MESH_INDEX (element = triangle).
// O(n).
IndexedMesh to_mesh(const cgw_mesh* given);

// The name is checked to be neither empty nor anything but UTF-8; the geometry is not looked at.
// Throws AbiError: INVALID_ARGUMENT (NULL, struct_size, unknown kind), SLIDE_NAME. O(n).
Slide to_slide(const cgw_slide_input* given);
// The same, but NULL and "" are names, too.
Slide to_slide_or_nameless(const cgw_slide_input* given);

}  // namespace cagewright::plugin
