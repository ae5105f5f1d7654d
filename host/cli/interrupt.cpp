// SPDX-License-Identifier: BSD-3-Clause
#include "host/cli/interrupt.h"

#include <csignal>

#include "host/plugin_client/plugin_error.h"

namespace cagewright::host {
namespace {

volatile std::sig_atomic_t interrupted = 0;

extern "C" void on_interrupt(int) { interrupted = 1; }

}  // namespace

void heed_interrupts() {
  struct sigaction action {};
  action.sa_handler = on_interrupt;
  action.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);
  ::sigaction(SIGINT, &action, nullptr);
}

bool was_interrupted() { return interrupted != 0; }

void throw_if_interrupted() {
  if (was_interrupted()) throw Cancelled();
}

}  // namespace cagewright::host
