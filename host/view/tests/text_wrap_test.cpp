// SPDX-License-Identifier: BSD-3-Clause
#include "host/view/window/text_wrap.h"

#include <gtest/gtest.h>

namespace cagewright::host {
namespace {

TEST(TextWrap, BreaksAtSpacesBeforeLinesGetTooLong) {
  EXPECT_EQ(wrapped("one two three", 7), "one two\nthree");
  EXPECT_EQ(wrapped("one two three", 6), "one\ntwo\nthree");
  EXPECT_EQ(wrapped("one two three", 100), "one two three");
  EXPECT_EQ(wrapped("", 10), "");
}

TEST(TextWrap, LeavesLongWordsWholeAndLineBreaksWhereTheyAre) {
  EXPECT_EQ(wrapped("a incomprehensible b", 5), "a\nincomprehensible\nb");
  EXPECT_EQ(wrapped("first line\nsecond", 40), "first line\nsecond");
}

TEST(TextWrap, CountsCharactersNotBytes) { EXPECT_EQ(wrapped("äöü äöü x", 7), "äöü äöü\nx"); }

}  // namespace
}  // namespace cagewright::host
