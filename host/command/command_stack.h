// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_COMMAND_COMMAND_STACK_H
#define CAGEWRIGHT_HOST_COMMAND_COMMAND_STACK_H

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "host/command/command.h"

namespace cagewright::host {

// What was done to a document, for undo and redo. The document outlives the stack.
class CommandStack {
 public:
  explicit CommandStack(SceneDocument& document) : document_(document) {}

  // Does it; what was undone can then no longer be redone. Throws CommandError, and then nothing has changed.
  void run(std::unique_ptr<Command> command);
  // False where there is nothing to undo or redo.
  bool undo();
  bool redo();

  // Which of the states that the document has gone through it is in: equal numbers, equal bytes. 0: before any command.
  std::uint64_t state() const { return done_.empty() ? 0 : done_.back().number; }
  bool can_undo() const { return !done_.empty(); }
  bool can_redo() const { return !undone_.empty(); }

  // The label of what undo() or redo() would take back or do again; empty where there is nothing.
  std::string undo_label() const;
  std::string redo_label() const;

 private:
  SceneDocument& document_;
  struct Done {
    std::unique_ptr<Command> command;
    std::uint64_t number;
  };
  std::vector<Done> done_, undone_;  // the last one is the next
  std::uint64_t last_number_ = 0;
};

}  // namespace cagewright::host

#endif
