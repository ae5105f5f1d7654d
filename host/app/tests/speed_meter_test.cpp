// SPDX-License-Identifier: BSD-3-Clause
#include "host/app/speed_meter.h"

#include <gtest/gtest.h>

namespace cagewright::host {
namespace {

using std::chrono::milliseconds;

TEST(SpeedMeter, SaysCagesASecondFromTheFirstToTheLastAndHowLongOneTakes) {
  SpeedMeter meter;
  const SpeedMeter::Clock::time_point begin;
  meter.begin(begin);
  for (int k = 1; k <= 5; ++k)
    meter.add(begin + milliseconds(500 * k), begin + milliseconds(500 * k + 40), milliseconds(12));
  EXPECT_EQ(meter.figures().cages, 5u);
  EXPECT_EQ(speed_text(meter.figures()), "cage 2.0/s, 40 ms (95 %: 40 ms), frame 12 ms");
}

TEST(SpeedMeter, OfFewCagesASecondSaysOneDecimalSoThatTheyAreNotNone) {
  const auto text = [](double per_second) { return speed_text({9, per_second, 500, 500, 12}).substr(0, 10); };
  EXPECT_EQ(text(0.04), "cage < 0.1");
  EXPECT_EQ(text(1.8), "cage 1.8/s");
  EXPECT_EQ(text(9.94), "cage 9.9/s");
  EXPECT_EQ(text(9.96), "cage 10/s,");
  EXPECT_EQ(text(31.4), "cage 31/s,");
}

TEST(SpeedMeter, AFrameOfACageThatWasThereBeforeIsNoCageMore) {
  SpeedMeter meter;
  const SpeedMeter::Clock::time_point begin;
  meter.begin(begin);
  meter.add(begin, begin + milliseconds(10), milliseconds(10));
  EXPECT_EQ(speed_text(meter.figures()), "cage: drag a slide");
}

}  // namespace
}  // namespace cagewright::host
