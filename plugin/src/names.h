// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "cagewright/cagewright.h"

namespace cagewright::plugin {

// "mesh_open", "cancelled"; "unknown" for a number that is no status. Static.
const char* status_name(cgw_status status) noexcept;

// "segment", "orient", "meshing", "refine"; "unknown" for others. Static.
const char* stage_name(std::int32_t stage) noexcept;

}  // namespace cagewright::plugin
