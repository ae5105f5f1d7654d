// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_WORKSPACE_FIND_PROBLEM_H
#define CAGEWRIGHT_HOST_WORKSPACE_FIND_PROBLEM_H

#include <algorithm>

#include "host/workspace/cage_state.h"

namespace cagewright::host {

// The first problem that names a slide, by its id, advice as well; null: none does.
inline const Problem* find_problem_or_advice(const CageState& cage, std::int64_t slide) {
  const auto found = std::ranges::find_if(cage.problems, [slide](const Problem& problem) {
    return std::ranges::find(problem.slides, slide) != problem.slides.end();
  });
  return found == cage.problems.end() ? nullptr : &*found;
}

// What keeps a slide from having a cage, by its id; null: nothing. The first where there are several.
inline const Problem* find_problem(const CageState& cage, std::int64_t slide) {
  return cage.failed ? find_problem_or_advice(cage, slide) : nullptr;
}

}  // namespace cagewright::host

#endif
