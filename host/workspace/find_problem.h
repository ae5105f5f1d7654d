// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_WORKSPACE_FIND_PROBLEM_H
#define CAGEWRIGHT_HOST_WORKSPACE_FIND_PROBLEM_H

#include <algorithm>

#include "host/workspace/cage_state.h"

namespace cagewright::host {

// What keeps a slide from having a cage, by its id; null: nothing. The first where there are several.
inline const Problem* find_problem(const CageState& cage, std::int64_t slide) {
  if (!cage.failed) return nullptr;
  const auto found = std::ranges::find_if(cage.problems, [slide](const Problem& problem) {
    return std::ranges::find(problem.slides, slide) != problem.slides.end();
  });
  return found == cage.problems.end() ? nullptr : &*found;
}

}  // namespace cagewright::host

#endif
