// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_VIEW_DISPLAY_H
#define CAGEWRIGHT_HOST_VIEW_DISPLAY_H

namespace cagewright::host {

// The process's connection to the X display that DISPLAY names, an Xlib `Display*`; made at the first call and kept
// until the process ends or DISPLAY names another one. VTK given a display that does not answer would end the process;
// this throws PictureError (no_display) with one sentence that says what is missing and what to do. Looks for GLX, too.
// Main thread only.
void* display_connection();

}  // namespace cagewright::host

#endif
