// SPDX-License-Identifier: BSD-3-Clause
#include "host/app/turntable_text.h"

namespace cagewright::host {

std::string cancelled_turntable_text(int drawn, int frames, const std::string& folder) {
  if (drawn == 0) return "Cancelled: no frame was written";
  const std::string which = drawn == 1 ? "frame 1" : "frames 1 to " + std::to_string(drawn);
  return "Cancelled: " + which + " of " + std::to_string(frames) + (drawn == 1 ? " is in " : " are in ") + folder +
         ", the others were not drawn";
}

}  // namespace cagewright::host
