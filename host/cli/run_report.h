// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_CLI_RUN_REPORT_H
#define CAGEWRIGHT_HOST_CLI_RUN_REPORT_H

#include "host/cli/command_line.h"
#include "host/file/report_file.h"
#include "host/workspace/describe_run.h"

namespace cagewright::host {

// The options that a report of this command begins with.
RunOptions options_of(const CageCommand& command);

// What the certificate and the tightness come to, a line or more each, for stdout.
std::string certificate_summary(const Report::Certificate& certificate);
std::string tightness_text(const Report::Tightness& tightness);

}  // namespace cagewright::host

#endif
