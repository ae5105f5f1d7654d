// SPDX-License-Identifier: BSD-3-Clause
#include "host/view/display.h"

#include <X11/Xlib.h>

#include <chrono>
#include <cstdlib>
#include <memory>
#include <string>
#include <thread>

#include "host/view/picture.h"

namespace cagewright::host {
namespace {

struct CloseDisplay {
  void operator()(Display* display) const { XCloseDisplay(display); }
};
using Connection = std::unique_ptr<Display, CloseDisplay>;

[[noreturn]] void no_display(const std::string& what) {
  throw PictureError(PictureFault::no_display,
                     what + "; run the program under `xvfb-run -a`, or on a desktop, or leave the picture out");
}

// An X server without -noreset starts afresh when its last client leaves, and refuses whoever comes in that moment:
// hence a few tries, and hence the connection that stays open.
Connection connect(const std::string& name) {
  constexpr int kTries = 4;
  constexpr std::chrono::milliseconds kPause{100};
  for (int i = 0; i < kTries; ++i) {
    if (Connection display{XOpenDisplay(name.c_str())}) {
      return display;
    }
    std::this_thread::sleep_for(kPause);
  }
  no_display("a picture needs an X display, and none answers at DISPLAY=" + name);
}

}  // namespace

void* display_connection() {
  // Never closed at the end of the process: closing unloads the OpenGL driver, which may still have work to do then.
  static Display* connection = nullptr;
  static std::string connected_to;
  const char* name = std::getenv("DISPLAY");
  if (name == nullptr || *name == '\0') {
    no_display("a picture needs an X display, and DISPLAY is not set");
  }
  if (connection == nullptr || connected_to != name) {
    Connection fresh = connect(name);
    int opcode = 0;
    int event = 0;
    int error = 0;
    if (XQueryExtension(fresh.get(), "GLX", &opcode, &event, &error) == False) {
      no_display(std::string("a picture needs OpenGL, and the X display DISPLAY=") + name + " has no GLX");
    }
    if (connection != nullptr) {
      XCloseDisplay(connection);
    }
    connection = fresh.release();
    connected_to = name;
  }
  return connection;
}

}  // namespace cagewright::host
