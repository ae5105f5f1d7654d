// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_COMMAND_CAGE_COMMANDS_H
#define CAGEWRIGHT_HOST_COMMAND_CAGE_COMMANDS_H

#include <optional>

#include "host/command/command.h"

namespace cagewright::host {

// The cage of a mesh node, in the place of the one it had: with its material, its children and what else others have
// given to its node, and with its name where the new one has none. doIt throws CommandError where a file could not hold
// it: no such mesh node; no triangles, or one whose vertex is not there; positions beyond a float; a name that is no
// UTF-8; a parameter that is not finite; sections of other vertices or slides than there are; a certificate that is not
// JSON.
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

// By its row among the document's strays. doIt throws CommandError: there is none.
class RemoveStray : public Command {
 public:
  explicit RemoveStray(std::size_t row);
  std::string label() const override;
  void doIt(SceneDocument& document) override;
  void undoIt(SceneDocument& document) override;
  void redoIt(SceneDocument& document) override;

 private:
  std::size_t row_;
  SceneStray removed_;
};

}  // namespace cagewright::host

#endif
