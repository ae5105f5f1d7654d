// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_WORKSPACE_SOLVED_CAGE_H
#define CAGEWRIGHT_HOST_WORKSPACE_SOLVED_CAGE_H

#include <vector>

#include "host/plugin_client/plugin_error.h"
#include "host/plugin_client/session.h"
#include "host/workspace/cage_solver.h"

namespace cagewright::host {

// What a session that has solved the request's slides holds. Editing: cage and sections alone. Throws PluginError and
// Cancelled.
CageState read_cage_state(const Plugin& plugin, const Session& session, const SolveRequest& request);

// What kept the request from a cage: the plug-in's sentence and place with the slides at fault, then what it says of
// others. `session`: null where it did not come to solving the request's slides.
std::vector<Problem> problems_of(const PluginError& error, const Session* session, const SolveRequest& request);

// Of a whole cage: where its certificate failed, its sentence and the slides that it names.
std::vector<Problem> problems_of(const CageState& state, const SolveRequest& request);

}  // namespace cagewright::host

#endif
