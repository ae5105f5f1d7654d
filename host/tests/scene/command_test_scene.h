// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_TESTS_SCENE_COMMAND_TEST_SCENE_H
#define CAGEWRIGHT_HOST_TESTS_SCENE_COMMAND_TEST_SCENE_H

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "host/command/command.h"
#include "host/tests/scene/scene_files.h"

namespace cagewright::host::test {

inline SceneDocument own_scene(const std::string& name) {
  return SceneDocument(std::filesystem::path(CAGEWRIGHT_OWN_SCENES) / name);
}

// doIt throws a CommandError of one line that holds all parts, and leaves the document as it was.
inline void expect_refused(SceneDocument& document, Command&& command, const std::vector<std::string>& parts) {
  const std::string before = document.bytes();
  try {
    command.doIt(document);
    ADD_FAILURE() << "nothing was thrown; expected: " << testing::PrintToString(parts);
  } catch (const CommandError& error) {
    const std::string sentence = error.what();
    EXPECT_EQ(sentence.find('\n'), std::string::npos) << sentence;
    for (const std::string& part : parts)
      EXPECT_NE(sentence.find(part), sentence.npos) << part << "\nis not in: " << sentence;
  }
  EXPECT_EQ(document.bytes(), before);
}

// doIt, undoIt and redoIt lead to two states and no third one, to the byte; the document is left as after doIt.
inline void expect_reversible(SceneDocument& document, Command& command) {
  const std::string before = document.bytes();
  command.doIt(document);
  const std::string after = document.bytes();
  EXPECT_NE(after, before);
  for (int again = 0; again < 2; ++again) {
    command.undoIt(document);
    EXPECT_EQ(document.bytes(), before);
    command.redoIt(document);
    EXPECT_EQ(document.bytes(), after);
  }
}

}  // namespace cagewright::host::test

#endif
