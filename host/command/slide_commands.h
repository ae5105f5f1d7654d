// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_COMMAND_SLIDE_COMMANDS_H
#define CAGEWRIGHT_HOST_COMMAND_SLIDE_COMMANDS_H

#include <optional>

#include "host/command/command.h"

namespace cagewright::host {

// A new slide under a mesh node. doIt throws CommandError: no such mesh node; the name is empty, no UTF-8 or taken
// there; the ellipse is not finite or its radii span no plane; the stroke is not finite.
class AddSlide : public Command {
 public:
  AddSlide(int mesh_node, std::string name, const Slide::Ellipse& ellipse, std::vector<Point3> stroke = {});
  std::string label() const override;
  void doIt(SceneDocument& document) override;
  void undoIt(SceneDocument& document) override;
  void redoIt(SceneDocument& document) override;

  // The new slide's id, once it is done.
  std::int64_t id() const { return slide_.id; }

 private:
  SceneSlide slide_;
};

// A slide's ellipse is another one; with the stroke that it was fitted to, or without. doIt throws CommandError: no
// such slide; an ellipse or a stroke as above.
class ChangeSlide : public Command {
 public:
  ChangeSlide(std::int64_t id, const Slide::Ellipse& ellipse, std::vector<Point3> stroke = {});
  std::string label() const override;
  void doIt(SceneDocument& document) override;
  void undoIt(SceneDocument& document) override;
  void redoIt(SceneDocument& document) override;

 private:
  std::int64_t id_;
  Slide::Ellipse ellipse_;
  std::vector<Point3> stroke_;
  SceneSlide before_;
};

// doIt throws CommandError: no such slide; a name as above.
class RenameSlide : public Command {
 public:
  RenameSlide(std::int64_t id, std::string name);
  std::string label() const override;
  void doIt(SceneDocument& document) override;
  void undoIt(SceneDocument& document) override;
  void redoIt(SceneDocument& document) override;

 private:
  std::int64_t id_;
  std::string name_, before_;
};

// doIt throws CommandError: no such slide.
class RemoveSlide : public Command {
 public:
  explicit RemoveSlide(std::int64_t id);
  std::string label() const override;
  void doIt(SceneDocument& document) override;
  void undoIt(SceneDocument& document) override;
  void redoIt(SceneDocument& document) override;

 private:
  std::int64_t id_;
  std::size_t row_ = 0;
  SceneSlide removed_;
};

}  // namespace cagewright::host

#endif
