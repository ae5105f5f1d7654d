// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_CLI_CAGE_SOLVE_H
#define CAGEWRIGHT_HOST_CLI_CAGE_SOLVE_H

#include <memory>

#include "host/cli/cage_input.h"
#include "host/cli/command_line.h"
#include "host/file/report_file.h"
#include "host/plugin_client/session.h"

namespace cagewright::host {

// A target's cage, and the session that made it.
struct SolvedCage {
  std::unique_ptr<Session> session;
  TriangleMesh cage;
  bool is_good = false;  // certified, where that was asked for; else closed
  Report report;         // without read, write and total times and memory
};

// Throws InputError where the plug-in refuses model, slides or parameters, with the file or option before its sentence;
// PluginError and Cancelled.
SolvedCage solve_cage(const CageCommand& command, const std::shared_ptr<const Plugin>& plugin, const CageTarget& target,
                      SessionListener listener);

}  // namespace cagewright::host

#endif
