// SPDX-License-Identifier: BSD-3-Clause
#include "host/app/age_text.h"

namespace cagewright::host {

std::string age_text(std::chrono::seconds age) {
  const struct {
    long long seconds;
    const char* name;
  } units[] = {{24 * 60 * 60, "day"}, {60 * 60, "hour"}, {60, "minute"}};
  for (const auto& unit : units) {
    const long long count = age.count() / unit.seconds;
    if (count > 0) return std::to_string(count) + " " + unit.name + (count == 1 ? "" : "s") + " ago";
  }
  return "less than a minute ago";
}

}  // namespace cagewright::host
