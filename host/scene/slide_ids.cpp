// SPDX-License-Identifier: BSD-3-Clause
#include "host/scene/slide_ids.h"

namespace cagewright::host {

std::int64_t SlideIds::take_next() {
  std::int64_t id = taken_.empty() ? 1 : *taken_.rbegin() + 1;
  if (id > largest_slide_id) {
    while (taken_.count(least_free_) > 0) ++least_free_;
    id = least_free_;
  }
  taken_.insert(id);
  return id;
}

}  // namespace cagewright::host
