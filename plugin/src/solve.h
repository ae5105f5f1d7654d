// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "plugin/src/session.h"

namespace cagewright::plugin {

// Makes the cage, or the stages up to options->last_stage (`options` may be NULL), and keeps it as the session's
// results. Where it throws, the old results stay; every slide that keeps the cage from being made
// is blamed, the first of them by what is thrown.
// Throws AbiError: NOT_READY (no model), INVALID_ARGUMENT, CANCELLED, those of the stages with slides as ids.
void solve(cgw_session& session, const cgw_solve_options* options);

}  // namespace cagewright::plugin
