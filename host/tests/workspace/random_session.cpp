// SPDX-License-Identifier: BSD-3-Clause
#include "host/tests/workspace/random_session.h"

#include <gtest/gtest.h>

#include <optional>

namespace cagewright::host::test {

RandomSession::RandomSession(Workspace& workspace, ScriptRunner& runner, unsigned seed)
    : workspace_(workspace), runner_(runner), commands_(workspace, seed), states_{bytes()} {}

RandomSession::Bytes RandomSession::bytes() const {
  const SceneDocument& document = workspace_.document();
  return {document.copy_as(true).bytes(), document.copy_as(false).bytes()};
}

void RandomSession::expect_unchanged(const std::string& why) const {
  EXPECT_TRUE(bytes() == states_[position_]) << why;
  const CommandStack& stack = workspace_.stack();
  EXPECT_EQ(stack.undo_label(), position_ == 0 ? "" : labels_[position_ - 1]) << why;
  EXPECT_EQ(stack.redo_label(), position_ == steps() ? "" : labels_[position_]) << why;
}

void RandomSession::give(const nlohmann::json& command) {
  SCOPED_TRACE(command.dump());
  const std::string name = command["command"].get<std::string>();
  const std::uint64_t before = workspace_.stack().state();
  std::optional<nlohmann::json> said;
  try {
    said = runner_.run(command);
  } catch (const std::runtime_error&) {
    ++refused_[name];
    return expect_unchanged("it was refused");
  }
  ++done_[name];
  if (name == "undo") {
    ASSERT_GT(position_, 0U);
    EXPECT_EQ((*said)["undone"], labels_[--position_]);
  } else if (name == "redo") {
    ASSERT_LT(position_, steps());
    EXPECT_EQ((*said)["redone"], labels_[position_++]);
  } else if (workspace_.stack().state() != before) {
    EXPECT_EQ(RandomCommands::changing().count(name), 1U) << "it is no step of undo";
    states_.resize(++position_);
    labels_.resize(position_ - 1);
    states_.push_back(bytes());
    labels_.push_back(workspace_.stack().undo_label());
  }
  expect_unchanged("as it was at this step");
}

void RandomSession::run(std::size_t changes) {
  std::size_t count = 0;
  while (count < changes && !testing::Test::HasFailure()) {
    const nlohmann::json command = commands_.next();
    const std::string name = command["command"].get<std::string>();
    const std::size_t before = done_[name];
    give(command);
    if (RandomCommands::changing().count(name) > 0) count += done_[name] - before;
  }
}

void RandomSession::step(const char* command, std::size_t to, const AtStep& each) {
  if (each) each();
  while (position_ != to && !testing::Test::HasFailure()) {
    SCOPED_TRACE("at step " + std::to_string(position_) + " of " + std::to_string(steps()));
    give({{"command", command}});
    if (each) each();
  }
}

void RandomSession::undo_to(std::size_t position, const AtStep& each) { step("undo", position, each); }

void RandomSession::redo_to(std::size_t position, const AtStep& each) { step("redo", position, each); }

}  // namespace cagewright::host::test
