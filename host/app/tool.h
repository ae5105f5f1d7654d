// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_APP_TOOL_H
#define CAGEWRIGHT_HOST_APP_TOOL_H

#include <QString>

namespace cagewright::host {

// Display coordinates: pixels of the window from its lower left corner, as VTK has them.
struct MousePoint {
  double x = 0, y = 0;
  bool shift = false, control = false;
};

// What the left button does in the view.
class Tool {
 public:
  virtual ~Tool() = default;

  // Whether a press is the tool's; where not, it turns the view.
  virtual bool press(const MousePoint& at) = 0;
  virtual void drag(const MousePoint& at) = 0;
  virtual void release(const MousePoint& at) = 0;
  virtual bool hover(const MousePoint&) { return false; }  // whether it changes what is seen
  // Escape, and before another tool is taken: as if it had not begun. False where it had not.
  virtual bool cancel() = 0;
  virtual QString hint() const = 0;  // for the status line: the next step
};

}  // namespace cagewright::host

#endif
