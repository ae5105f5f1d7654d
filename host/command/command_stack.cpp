// SPDX-License-Identifier: BSD-3-Clause
#include "host/command/command_stack.h"

#include <utility>

namespace cagewright::host {

void CommandStack::run(std::unique_ptr<Command> command) {
  done_.reserve(done_.size() + 1);  // what may throw comes before the change
  command->doIt(document_);
  done_.push_back({std::move(command), ++last_number_});
  undone_.clear();
}

bool CommandStack::undo() {
  if (done_.empty()) return false;
  undone_.reserve(undone_.size() + 1);
  done_.back().command->undoIt(document_);
  undone_.push_back(std::move(done_.back()));
  done_.pop_back();
  return true;
}

bool CommandStack::redo() {
  if (undone_.empty()) return false;
  done_.reserve(done_.size() + 1);
  undone_.back().command->redoIt(document_);
  done_.push_back(std::move(undone_.back()));
  undone_.pop_back();
  return true;
}

std::string CommandStack::undo_label() const { return done_.empty() ? "" : done_.back().command->label(); }
std::string CommandStack::redo_label() const { return undone_.empty() ? "" : undone_.back().command->label(); }

}  // namespace cagewright::host
