// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_CLI_INTERRUPT_H
#define CAGEWRIGHT_HOST_CLI_INTERRUPT_H

namespace cagewright::host {

// From here on the first SIGINT (Ctrl-C) only makes was_interrupted() true; the second ends the program at once, for
// when the first is not heeded.
void heed_interrupts();
bool was_interrupted();

// Throws Cancelled where was_interrupted().
void throw_if_interrupted();

}  // namespace cagewright::host

#endif
