// SPDX-License-Identifier: BSD-3-Clause
#include "host/app/turntable_text.h"

#include <gtest/gtest.h>

namespace cagewright::host {
namespace {

TEST(TurntableText, TellsWhichFramesAreThereAndWhere) {
  EXPECT_EQ(cancelled_turntable_text(0, 36, "/turn"), "Cancelled: no frame was written");
  EXPECT_EQ(cancelled_turntable_text(1, 36, "/turn"),
            "Cancelled: frame 1 of 36 is in /turn, the others were not drawn");
  EXPECT_EQ(cancelled_turntable_text(7, 36, "/turn"),
            "Cancelled: frames 1 to 7 of 36 are in /turn, the others were not drawn");
}

}  // namespace
}  // namespace cagewright::host
