// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_APP_DONE_TEXT_H
#define CAGEWRIGHT_HOST_APP_DONE_TEXT_H

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "host/workspace/workspace.h"

namespace cagewright::host {

// What the status line says after a command that leaves nothing to be seen in the window but a file: "Saved cow.glb".
// Empty for all others.
std::string done_text(const nlohmann::json& command, const Workspace& workspace);

}  // namespace cagewright::host

#endif
