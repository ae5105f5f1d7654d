// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/error/error.h"

namespace cagewright {

// Expects that `action` throws Error(code) whose sentence contains every one of `words`, and hands the error back.
template <class Action>
Error expect_error(Action action, ErrorCode code, const std::vector<std::string>& words) {
  try {
    action();
  } catch (const Error& error) {
    const std::string sentence = error.what();
    EXPECT_EQ(error.code(), code) << sentence;
    for (const std::string& word : words) {
      EXPECT_NE(sentence.find(word), std::string::npos) << "\"" << sentence << "\" does not say \"" << word << "\"";
    }
    return error;
  }
  ADD_FAILURE() << "nothing was thrown";
  return Error(ErrorCode::internal, "nothing was thrown");
}

}  // namespace cagewright
