// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_COMMAND_COMMAND_H
#define CAGEWRIGHT_HOST_COMMAND_COMMAND_H

#include <stdexcept>
#include <string>

#include "host/scene/scene_document.h"

namespace cagewright::host {

// What a document cannot do; what() names the slide or node and says what to do.
class CommandError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// One change of a document that can be taken back. Every change of a document is one.
class Command {
 public:
  virtual ~Command() = default;

  // For menus: "add slide 'knee'".
  virtual std::string label() const = 0;

  // Once, first. Throws CommandError and then leaves the document as it was.
  virtual void doIt(SceneDocument& document) = 0;
  // The document is as doIt or redoIt has left it; makes it as it was before, to the byte.
  virtual void undoIt(SceneDocument& document) = 0;
  // The document is as before doIt; makes it as doIt has left it, to the byte.
  virtual void redoIt(SceneDocument& document) = 0;
};

}  // namespace cagewright::host

#endif
