// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_APP_DONE_TEXT_H
#define CAGEWRIGHT_HOST_APP_DONE_TEXT_H

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "host/workspace/workspace.h"

namespace cagewright::host {

// What the status line says after a command that leaves nothing to be seen in the window but a file: "Saved cow.glb".
// And after a stroke across a limb whose plane was tilted, or whose slide is much longer than it: "slide 4 is 4.2 times
// as long as the stroke: ...". Empty for all others. `said` is the command's answer.
std::string done_text(const nlohmann::json& command, const nlohmann::json& said, const Workspace& workspace);

}  // namespace cagewright::host

#endif
