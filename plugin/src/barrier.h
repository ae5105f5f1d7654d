// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>

#include "cagewright/cagewright.h"
#include "core/error/error.h"

namespace cagewright::plugin {

// The one error of the plug-in. what() is the sentence that last_error hands out: the culprit and the next step.
class AbiError : public std::runtime_error {
 public:
  AbiError(cgw_status code, const std::string& sentence);
  AbiError(const cgw_error_info& info, const std::string& sentence);
  const cgw_error_info& info() const { return info_; }

 private:
  cgw_error_info info_ = CGW_ERROR_INFO_INIT;
};

// An error of the core in the terms of the C ABI. `ids[k]` is the id of the slide that the core knows as k; a slide
// that is not there becomes CGW_NO_ID.
AbiError to_abi_error(const Error& error, std::span<const std::uint64_t> ids);

// What last_error and last_error_info tell. Of fixed size, so that telling of an error cannot fail, and without a
// destructor: a thread_local with one would keep the plug-in loaded until the thread ends.
struct LastError {
  cgw_error_info info = CGW_ERROR_INFO_INIT;
  char sentence[1024] = "";

  // Keeps as much of `text` as fits, cut between two UTF-8 characters.
  void set(const cgw_error_info& what, const char* text) noexcept;
};

// Of the last call without a session on this thread.
LastError& thread_error() noexcept;

// Call in a catch block: translates the exception in flight, keeps it in `error`, returns its status.
cgw_status keep_exception(LastError& error) noexcept;

// The barrier round every entry of the table: runs `body`, lets no exception out. On success `error` keeps what the
// last failure left there.
template <class Body>
cgw_status guard(LastError& error, Body&& body) noexcept {
  try {
    std::forward<Body>(body)();
    return CGW_OK;
  } catch (...) {
    return keep_exception(error);
  }
}

// Marks a session as busy as long as it lives.
class Call {
 public:
  // Throws AbiError(INVALID_ARGUMENT) where the session is busy already.
  explicit Call(std::atomic<bool>& busy);
  ~Call() { busy_ = false; }
  Call(const Call&) = delete;
  Call& operator=(const Call&) = delete;

 private:
  std::atomic<bool>& busy_;
};

// The same for an entry that needs a session (const or not): body(session). That it is NULL or busy is told to the
// thread: the session's error belongs to the call that it is busy with.
template <class Session, class Body>
cgw_status guard_session(Session* session, Body&& body) noexcept {
  std::optional<Call> call;
  const cgw_status entered = guard(thread_error(), [&] {
    if (!session) throw AbiError(CGW_ERROR_INVALID_ARGUMENT, "the session is NULL; make one with session_create");
    call.emplace(session->busy);
  });
  if (entered != CGW_OK) return entered;
  return guard(session->last_error, [&] { std::forward<Body>(body)(*session); });
}

}  // namespace cagewright::plugin
