// SPDX-License-Identifier: BSD-3-Clause
#include "host/app/speed_meter.h"

#include <algorithm>
#include <cstdio>

namespace cagewright::host {
namespace {

double percentile(std::vector<double> values, double share) {
  if (values.empty()) return 0;
  const auto rank = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + rank, values.end());
  return values[static_cast<std::size_t>(rank)];
}

}  // namespace

void SpeedMeter::begin(Clock::time_point drawn) {
  *this = {};
  last_asked_ = drawn;
}

void SpeedMeter::add(Clock::time_point asked, Clock::time_point shown,
                     std::chrono::duration<double, std::milli> frame) {
  frames_.push_back(frame.count());
  if (asked == last_asked_) return;  // a frame of a cage that was there before
  last_asked_ = asked;
  cages_.push_back(std::chrono::duration<double, std::milli>(shown - asked).count());
  if (cages_.size() == 1) first_ = shown;
  last_ = shown;
}

SpeedMeter::Figures SpeedMeter::figures() const {
  Figures figures{cages_.size(), 0, percentile(cages_, 0.5), percentile(cages_, 0.95), percentile(frames_, 0.5)};
  const double seconds = std::chrono::duration<double>(last_ - first_).count();
  if (cages_.size() > 1 && seconds > 0) figures.cages_per_second = static_cast<double>(cages_.size() - 1) / seconds;
  return figures;
}

std::string speed_text(const SpeedMeter::Figures& figures) {
  if (figures.cages == 0) return "cage: drag a slide";
  char text[120];
  const int decimals = figures.cages_per_second < 9.95 ? 1 : 0;
  const bool is_hardly_any = figures.cages_per_second > 0 && figures.cages_per_second < 0.1;
  std::snprintf(text, sizeof text, "cage %s%.*f/s, %.0f ms (95 %%: %.0f ms), frame %.0f ms", is_hardly_any ? "< " : "",
                decimals, is_hardly_any ? 0.1 : figures.cages_per_second, figures.median_ms, figures.percentile_95_ms,
                figures.frame_ms);
  return text;
}

}  // namespace cagewright::host
