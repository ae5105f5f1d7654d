// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_APP_TURNTABLE_TEXT_H
#define CAGEWRIGHT_HOST_APP_TURNTABLE_TEXT_H

#include <string>

namespace cagewright::host {

// A sentence for the status line about a turntable that was cancelled after `drawn` frames.
std::string cancelled_turntable_text(int drawn, int frames, const std::string& folder);

}  // namespace cagewright::host

#endif
