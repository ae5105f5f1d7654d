// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_COMMAND_SET_PARAMETERS_H
#define CAGEWRIGHT_HOST_COMMAND_SET_PARAMETERS_H

#include <string>
#include <utility>
#include <vector>

#include "host/command/command.h"

namespace cagewright::host {

// The plug-in's parameters for the cage of a mesh node. What they may be is for the plug-in to say. doIt throws
// CommandError: no such mesh node; a name that is no UTF-8 or a value that is not finite.
class SetParameters : public Command {
 public:
  using Values = std::vector<std::pair<std::string, double>>;
  SetParameters(int mesh_node, Values values, std::string label);
  std::string label() const override;
  void doIt(SceneDocument& document) override;
  void undoIt(SceneDocument& document) override;
  void redoIt(SceneDocument& document) override;

 private:
  int mesh_node_;
  Values values_, before_;
  std::string label_;
};

}  // namespace cagewright::host

#endif
