// SPDX-License-Identifier: BSD-3-Clause
#include "host/app/age_text.h"

#include <gtest/gtest.h>

namespace cagewright::host {
namespace {

using std::chrono::seconds;

TEST(AgeText, IsInTheLargestUnitOfWhichThereIsAWholeOne) {
  EXPECT_EQ(age_text(seconds(0)), "less than a minute ago");
  EXPECT_EQ(age_text(seconds(59)), "less than a minute ago");
  EXPECT_EQ(age_text(seconds(60)), "1 minute ago");
  EXPECT_EQ(age_text(seconds(3 * 60 + 59)), "3 minutes ago");
  EXPECT_EQ(age_text(seconds(3600)), "1 hour ago");
  EXPECT_EQ(age_text(seconds(23 * 3600 + 3599)), "23 hours ago");
  EXPECT_EQ(age_text(seconds(49 * 3600)), "2 days ago");
}

TEST(AgeText, OfTheFutureIsOfNow) { EXPECT_EQ(age_text(seconds(-500)), "less than a minute ago"); }

}  // namespace
}  // namespace cagewright::host
