// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_COMMAND_COMMAND_GROUP_H
#define CAGEWRIGHT_HOST_COMMAND_COMMAND_GROUP_H

#include <memory>
#include <string>
#include <vector>

#include "host/command/command.h"

namespace cagewright::host {

// Several commands as one step: "remove 3 slides". doIt does them in their order and throws what one of them throws,
// once those before it are undone.
class CommandGroup : public Command {
 public:
  CommandGroup(std::string label, std::vector<std::unique_ptr<Command>> commands);
  std::string label() const override;
  void doIt(SceneDocument& document) override;
  void undoIt(SceneDocument& document) override;
  void redoIt(SceneDocument& document) override;

 private:
  std::string label_;
  std::vector<std::unique_ptr<Command>> commands_;
};

}  // namespace cagewright::host

#endif
