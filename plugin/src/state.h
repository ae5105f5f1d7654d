// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "plugin/src/session.h"

// Saved states: slides and parameters of a session. docs/c-abi.md describes the bytes.
namespace cagewright::plugin {

// Throws AbiError: NOT_READY (no model), INVALID_ARGUMENT, STREAM. The same session gives the same bytes. O(size).
void save_state(const cgw_session& session, const cgw_stream* stream);

// Replaces slides and parameters, drops the results; the slides get their saved ids. Never reads past the end of the
// state, and allocates no more than twice what the stream has delivered. Where it throws, the session is as it was.
// Throws AbiError: NOT_READY, INVALID_ARGUMENT, STREAM, STATE_*. O(size + slides^2).
void load_state(cgw_session& session, const cgw_stream* stream);

}  // namespace cagewright::plugin
