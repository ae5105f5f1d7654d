// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_CLI_INTERRUPT_H
#define CAGEWRIGHT_HOST_CLI_INTERRUPT_H

namespace cagewright::host {

// From here on SIGINT (Ctrl-C) and SIGTERM end the program at once with exit_cancelled and one line on stderr, for
// whatever it does, nothing has been written: but not while a HeededInterrupts lives. Once, before threads are started.
void end_on_interrupts();

// The part of a run that must not simply be ended: it has a way of its own to stop, or files to clear away. While one
// lives, the first signal only makes was_interrupted() true; the second ends the program as if nobody handled it, for
// when the first is not heeded. One at a time. Throws Cancelled where a signal has come already.
class HeededInterrupts {
 public:
  HeededInterrupts();
  ~HeededInterrupts();
  HeededInterrupts(const HeededInterrupts&) = delete;
  HeededInterrupts& operator=(const HeededInterrupts&) = delete;
};

// From here on signals are ignored: the files are there, and what is left takes no time. Call it while a
// HeededInterrupts lives, lest a signal between the two says that nothing was written.
void ignore_interrupts();

bool was_interrupted();

// Throws Cancelled where was_interrupted().
void throw_if_interrupted();

}  // namespace cagewright::host

#endif
