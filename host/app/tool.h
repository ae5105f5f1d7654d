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
  virtual void hover(const MousePoint&) {}
  virtual void cancel() = 0;         // escape, and before another tool is taken: as if it had not begun
  virtual QString hint() const = 0;  // for the status line: the next step
};

}  // namespace cagewright::host

#endif
