// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_TESTS_EXPECT_FILE_ERROR_H
#define CAGEWRIGHT_HOST_TESTS_EXPECT_FILE_ERROR_H

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "host/file/file_error.h"

namespace cagewright::host {

// Expects that `call` throws a FileError whose sentence is one line and holds every one of `parts`.
template <class Call>
void expect_file_error(Call call, const std::vector<std::string>& parts) {
  try {
    call();
  } catch (const FileError& error) {
    const std::string sentence = error.what();
    EXPECT_EQ(sentence.find('\n'), std::string::npos) << sentence;
    for (const std::string& part : parts)
      EXPECT_NE(sentence.find(part), sentence.npos) << part << "\nis not in: " << sentence;
    return;
  }
  ADD_FAILURE() << "nothing was thrown; expected: " << testing::PrintToString(parts);
}

}  // namespace cagewright::host

#endif
