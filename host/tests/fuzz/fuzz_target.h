// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_TESTS_FUZZ_FUZZ_TARGET_H
#define CAGEWRIGHT_HOST_TESTS_FUZZ_FUZZ_TARGET_H

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>

namespace cagewright::host {

// Ends the program, which libFuzzer takes for a finding.
inline void require(bool is_so, const char* otherwise) {
  if (is_so) return;
  std::fprintf(stderr, "finding: %s\n", otherwise);
  std::abort();
}

template <class Call>
void require_no_throw(const char* what, Call call) {
  try {
    call();
  } catch (const std::exception& error) {
    require(false, (std::string(what) + " has failed: " + error.what()).c_str());
  }
}

}  // namespace cagewright::host

// libFuzzer calls it with every input.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

#endif
