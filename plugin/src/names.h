// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "cagewright/cagewright.h"
#include "core/error/error.h"

namespace cagewright::plugin {

// "mesh_open", "cancelled"; "unknown" for a number that is no status. Static.
const char* status_name(cgw_status status) noexcept;

// The frozen status of the C ABI for an error of the core.
cgw_status status_of(ErrorCode code) noexcept;

// "segment", "orient", "meshing", "refine"; "unknown" for others. Static.
const char* stage_name(std::int32_t stage) noexcept;

}  // namespace cagewright::plugin
