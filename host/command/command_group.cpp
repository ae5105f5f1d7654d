// SPDX-License-Identifier: BSD-3-Clause
#include "host/command/command_group.h"

#include <utility>

namespace cagewright::host {

CommandGroup::CommandGroup(std::string label, std::vector<std::unique_ptr<Command>> commands)
    : label_(std::move(label)), commands_(std::move(commands)) {}

std::string CommandGroup::label() const { return label_; }

void CommandGroup::doIt(SceneDocument& document) {
  std::size_t done = 0;
  try {
    for (; done < commands_.size(); ++done) commands_[done]->doIt(document);
  } catch (...) {
    while (done > 0) commands_[--done]->undoIt(document);
    throw;
  }
}

void CommandGroup::undoIt(SceneDocument& document) {
  for (auto command = commands_.rbegin(); command != commands_.rend(); ++command) (*command)->undoIt(document);
}

void CommandGroup::redoIt(SceneDocument& document) {
  for (const auto& command : commands_) command->redoIt(document);
}

}  // namespace cagewright::host
