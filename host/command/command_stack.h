// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_COMMAND_COMMAND_STACK_H
#define CAGEWRIGHT_HOST_COMMAND_COMMAND_STACK_H

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

  // The label of what undo() or redo() would take back or do again; empty where there is nothing.
  std::string undo_label() const;
  std::string redo_label() const;

 private:
  SceneDocument& document_;
  std::vector<std::unique_ptr<Command>> done_, undone_;  // the last one is the next
};

}  // namespace cagewright::host

#endif
