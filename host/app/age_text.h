// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_APP_AGE_TEXT_H
#define CAGEWRIGHT_HOST_APP_AGE_TEXT_H

#include <chrono>
#include <string>

namespace cagewright::host {

// "3 minutes ago", in the largest unit of minutes, hours and days of which there is a whole one. What seems to be of
// the future, as on a machine whose clock is behind, is of now.
std::string age_text(std::chrono::seconds age);

}  // namespace cagewright::host

#endif
