// SPDX-License-Identifier: BSD-3-Clause
#include "core/enclose/finding.h"

#include <iomanip>
#include <sstream>

namespace cagewright {
namespace {

constexpr std::size_t most_pairs_named = 3;  // of limbs, in a sentence

std::string number(double value) {
  std::ostringstream text;
  text << std::setprecision(3) << value;
  return text.str();
}

template <class Pairs>
std::string limbs_text(const Pairs& limbs, const std::vector<std::string>& names) {
  std::string text;
  std::size_t count = 0;
  for (const auto& [a, b] : limbs) {
    if (count++ == most_pairs_named) break;
    text += (text.empty() ? "" : "; ") + ("the limbs at " + quoted({a}, names)) + " and " + quoted({b}, names);
  }
  return text + (limbs.size() > most_pairs_named ? "; and others" : "");
}

template <class Pairs>
void add_named(const Pairs& limbs, std::set<int>& slides) {
  std::size_t count = 0;
  for (const auto& [a, b] : limbs) {
    if (count++ == most_pairs_named) break;
    slides.insert({a, b});
  }
}

std::vector<int> listed(const std::set<int>& slides) { return {slides.begin(), slides.end()}; }

}  // namespace

std::string sentences_of(const std::vector<Finding>& findings) {
  std::string text;
  for (const Finding& finding : findings) text += (text.empty() ? "" : "; ") + finding.sentence;
  return text;
}

std::string quoted(const std::set<int>& slides, const std::vector<std::string>& names) {
  std::string text;
  for (const int k : slides) text += (text.empty() ? "'" : ", '") + names[static_cast<std::size_t>(k)] + "'";
  return text;
}

Finding too_near_finding(const TooNear& near, double kept, const Vector3& place,
                         const std::vector<std::string>& names) {
  std::string text =
      "the cage encloses the model, but not with the distance asked for everywhere; where it does not it keeps " +
      number(kept) +
      " of the diagonal: ask for less (refine.delta), or move limbs apart or add slides where they are close to each "
      "other, near " +
      quoted(near.slides, names);
  std::set<int> slides = near.slides;
  if (!near.conflicts.empty()) {
    text += "; in each other's way may be " + limbs_text(near.conflicts, names);
    add_named(near.conflicts, slides);
  }
  return {std::move(text), listed(slides), place};
}

Finding off_plane_finding(const std::set<int>& slides, const std::vector<std::string>& names) {
  return {"the cage encloses the model, but the sections of the slides " + quoted(slides, names) +
              " could not stay in their planes and near to square: move or turn these slides, or add one beside them",
          listed(slides),
          {}};
}

Finding too_large_finding(double ratio, const std::optional<Vector3>& place, const std::set<int>& slides,
                          const std::vector<std::string>& names) {
  std::string text = "the cage is " + number(ratio) +
                     " times as large as the model: let sections leave their slides' planes (enclose.in_plane=false), "
                     "or add slides where it stands off";
  if (!slides.empty()) text += ", farthest near " + quoted(slides, names);
  return {std::move(text), listed(slides), place};
}

Finding merged_finding(const SlidePairs& limbs, const std::vector<std::string>& names) {
  std::set<int> slides;
  add_named(limbs, slides);
  return {"the cages of " + limbs_text(limbs, names) +
              " run into each other and were made one there: move or turn these slides, or add one beside them, to "
              "keep them apart",
          listed(slides),
          {}};
}

}  // namespace cagewright
