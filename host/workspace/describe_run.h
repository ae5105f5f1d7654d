// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_WORKSPACE_DESCRIBE_RUN_H
#define CAGEWRIGHT_HOST_WORKSPACE_DESCRIBE_RUN_H

#include <string>
#include <utility>
#include <vector>

#include "host/file/report_file.h"
#include "host/plugin_client/plugin.h"
#include "host/plugin_client/session.h"

namespace cagewright::host {

// As reports and options have it: a choice by its name, a boolean as one.
Report::Option option_value(const Parameter& parameter, double value);

using RunOptions = std::vector<std::pair<std::string, Report::Option>>;

// What a solved session tells, without the timings of a program (read, write, total) and its memory. `cage` is what the
// plug-in says of the session's cage as a mesh. The report's options are `options` and the plug-in's parameters. Throws
// PluginError.
Report describe_run(RunOptions options, const Plugin& plugin, const Session& session, const TriangleMesh& cage,
                    const cgw_mesh_report& cage_report);

Report::Mesh describe_mesh(const cgw_mesh_report& report);
Report::Certificate describe_certificate(const Certificate& certificate);
Report::Tightness describe_tightness(const Measures& measures);
Report::Quality describe_quality(const Measures& measures);

// The largest memory that this process has held so far, in MiB.
double peak_memory_mb();

}  // namespace cagewright::host

#endif
