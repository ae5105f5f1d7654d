// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>

namespace cagewright {

// How many threads `requested` stands for: itself, or what the machine has where it is 0.
unsigned thread_count(unsigned requested);

// Calls body(i) for every i < count, on `threads` threads (0: all); returns when all are done and no thread is left.
// Which thread takes which i is not fixed, so bodies write to places of their own. The first exception is rethrown.
void parallel_for(std::size_t count, unsigned threads, const std::function<void(std::size_t)>& body);

}  // namespace cagewright
