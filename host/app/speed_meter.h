// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_APP_SPEED_METER_H
#define CAGEWRIGHT_HOST_APP_SPEED_METER_H

#include <chrono>
#include <cstddef>
#include <string>
#include <vector>

namespace cagewright::host {

// How quickly the cage on the screen follows the mouse, over one drag.
class SpeedMeter {
 public:
  using Clock = std::chrono::steady_clock;

  struct Figures {
    std::size_t cages = 0;        // that were shown
    double cages_per_second = 0;  // from the first to the last
    // From the movement to the frame that shows its cage, and of one frame; 0 where there was none.
    double median_ms = 0, percentile_95_ms = 0, frame_ms = 0;
  };

  void begin(Clock::time_point drawn);  // another drag; the cage that is shown answers the movement at `drawn`
  // A frame has been drawn, in that time, with the cage that answers the movement at `asked`.
  void add(Clock::time_point asked, Clock::time_point shown, std::chrono::duration<double, std::milli> frame);
  Figures figures() const;  // O(n log n)

 private:
  std::vector<double> cages_, frames_;  // milliseconds
  Clock::time_point first_, last_, last_asked_;
};

// For the view's corner: "cage 31/s, 27 ms (95 %: 41 ms), frame 12 ms"; below ten a second with one decimal.
std::string speed_text(const SpeedMeter::Figures& figures);

}  // namespace cagewright::host

#endif
