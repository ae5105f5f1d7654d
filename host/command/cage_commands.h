// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_COMMAND_CAGE_COMMANDS_H
#define CAGEWRIGHT_HOST_COMMAND_CAGE_COMMANDS_H

#include <optional>

#include "host/command/command.h"

namespace cagewright::host {

// The cage of a mesh node, in the place of the one it had. doIt throws CommandError where a file could not hold it: no
// such mesh node; no triangles, or one whose vertex is not there; positions beyond a float; a name that is no UTF-8; a
// parameter that is not finite; sections of other vertices or slides than there are; a certificate that is not JSON.
class SetCage : public Command {
 public:
  explicit SetCage(SceneCage cage);
  std::string label() const override;
  void doIt(SceneDocument& document) override;
  void undoIt(SceneDocument& document) override;
  void redoIt(SceneDocument& document) override;

 private:
  SceneCage cage_;
  std::optional<SceneCage> before_;
};

// doIt throws CommandError: the mesh node has no cage.
class RemoveCage : public Command {
 public:
  explicit RemoveCage(int mesh_node);
  std::string label() const override;
  void doIt(SceneDocument& document) override;
  void undoIt(SceneDocument& document) override;
  void redoIt(SceneDocument& document) override;

 private:
  int mesh_node_;
  std::optional<SceneCage> removed_;
};

}  // namespace cagewright::host

#endif
