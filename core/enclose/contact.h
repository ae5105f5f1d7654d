// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "core/mesh/types.h"

namespace cagewright {

// A linear condition on a step of the cage's vertices: the sum of gradient . step over the terms is at least `least`.
struct Contact {
  struct Term {
    int vertex = 0;
    Vector3 gradient = Vector3::Zero();
  };
  std::array<Term, 6> terms = {};
  int count = 0;
  double least = 0;     // model units
  double softness = 0;  // 0: has to hold; above: gives way in proportion to its force

  void add(int vertex, const Vector3& gradient) { terms[static_cast<std::size_t>(count++)] = {vertex, gradient}; }
};

using Contacts = std::vector<Contact>;

}  // namespace cagewright
