// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/enclose/certificate.h"
#include "core/enclose/clearance.h"
#include "core/mesh/types.h"

namespace cagewright {

// What keeps a cage from enclosing the model, or from the distance that was asked for, or could be better of it: one
// sentence, the slides that it names and, where one is known, a place, model units.
struct Finding {
  std::string sentence;
  std::vector<int> slides;  // ascending
  std::optional<Vector3> place;
  bool is_advice = false;  // it could be better, and nothing that was asked for is missing
};

using SlidePairs = std::vector<std::pair<int, int>>;

// The sentences of findings, divided by "; ".
std::string sentences_of(const std::vector<Finding>& findings);

// Names of slides in quotes, divided by commas.
std::string quoted(const std::set<int>& slides, const std::vector<std::string>& names);

// The cage could not be made to enclose the model: what its certificate misses, with the slides near the most of it;
// `are_all`: near all of it.
Finding not_enclosing_finding(const Certificate& certificate, const std::set<int>& slides, bool are_all, bool in_plane,
                              const std::vector<std::string>& names);
// The cage keeps `kept` of the diagonal, which is less than was asked for; least at `place`.
Finding too_near_finding(const TooNear& near, double kept, const Vector3& place, const std::vector<std::string>& names);
// Sections that could not stay in the planes of their slides.
Finding off_plane_finding(const std::set<int>& slides, const std::vector<std::string>& names);
// The cage is `ratio` times as large as the model; it stands off farthest at `place`, near these slides.
Finding too_large_finding(double ratio, const Vector3& place, const std::set<int>& slides,
                          const std::vector<std::string>& names);
// Limbs that were made one, by pairs of their slides; `lost`, ascending: those whose sections are whole no longer.
Finding merged_finding(const SlidePairs& limbs, const std::vector<int>& lost, bool in_plane,
                       const std::vector<std::string>& names);

}  // namespace cagewright
