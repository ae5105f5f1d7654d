// SPDX-License-Identifier: BSD-3-Clause
#include "host/cli/interrupt.h"

#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <string_view>

#include "host/cli/exit_code.h"
#include "host/plugin_client/plugin_error.h"

namespace cagewright::host {
namespace {

constexpr std::array signals = {SIGINT, SIGTERM};
// The second where stderr is a terminal: there a line of progress may stand.
constexpr std::string_view farewell = "cagewright: cancelled; nothing was written\n";
constexpr std::string_view farewell_on_terminal = "\r\033[Kcagewright: cancelled; nothing was written\n";

// Signals may arrive on any thread.
static_assert(std::atomic<bool>::is_always_lock_free);
std::atomic<bool> interrupted = false;
std::atomic<bool> is_heeded = false;
std::string_view last_words = farewell;

// Of both signals.
void set_action(void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;
  action.sa_flags = SA_RESTART;
  for (const int signal : signals) ::sigaddset(&action.sa_mask, signal);
  for (const int signal : signals) ::sigaction(signal, &action, nullptr);
}

// Only what POSIX allows in a signal handler.
extern "C" void on_interrupt(int) {
  const int error = errno;
  if (!is_heeded) {
    [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, last_words.data(), last_words.size());
    ::_exit(exit_cancelled);
  }
  interrupted = true;
  set_action(SIG_DFL);
  errno = error;
}

}  // namespace

void end_on_interrupts() {
  if (::isatty(STDERR_FILENO) == 1) last_words = farewell_on_terminal;
  set_action(on_interrupt);
}

HeededInterrupts::HeededInterrupts() {
  throw_if_interrupted();
  is_heeded = true;
}

HeededInterrupts::~HeededInterrupts() { is_heeded = false; }

void ignore_interrupts() { set_action(SIG_IGN); }

bool was_interrupted() { return interrupted; }

void throw_if_interrupted() {
  if (was_interrupted()) throw Cancelled();
}

}  // namespace cagewright::host
