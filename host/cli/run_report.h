// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_CLI_RUN_REPORT_H
#define CAGEWRIGHT_HOST_CLI_RUN_REPORT_H

#include "host/cli/command_line.h"
#include "host/file/report_file.h"
#include "host/plugin_client/plugin.h"
#include "host/plugin_client/session.h"

namespace cagewright::host {

// What a solved session tells, without the timings of this program (read, write, total) and its memory. `cage` is what
// the plug-in says of the session's cage as a mesh. Throws PluginError.
Report describe_run(const CageCommand& command, const Plugin& plugin, const Session& session, const TriangleMesh& cage,
                    const cgw_mesh_report& cage_report);

Report::Mesh describe_mesh(const cgw_mesh_report& report);
Report::Certificate describe_certificate(const Certificate& certificate);
Report::Tightness describe_tightness(const Measures& measures);
Report::Quality describe_quality(const Measures& measures);

// What the certificate and the tightness come to, a line or more each, for stdout.
std::string certificate_summary(const Report::Certificate& certificate);
std::string tightness_text(const Report::Tightness& tightness);

// The largest memory that this process has held so far, in MiB.
double peak_memory_mb();

}  // namespace cagewright::host

#endif
