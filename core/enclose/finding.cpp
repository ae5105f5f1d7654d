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

// A text, and which slides it names.
struct Limbs {
  std::string text;
  std::set<int> slides;
};

template <class Pairs>
Limbs limbs_of(const Pairs& pairs, const std::vector<std::string>& names) {
  Limbs limbs;
  std::size_t count = 0;
  for (const auto& [a, b] : pairs) {
    if (count++ == most_pairs_named) break;
    limbs.text +=
        (count == 1 ? "the limbs at " : ", and those at ") + quoted({a}, names) + " and " + quoted({b}, names);
    limbs.slides.insert({a, b});
  }
  if (pairs.size() > most_pairs_named) limbs.text += ", and others";
  return limbs;
}

// "the section of the slide 'knee'", and of more.
std::string sections_of(const std::set<int>& slides, const std::vector<std::string>& names) {
  return (slides.size() == 1 ? "the section of the slide " : "the sections of the slides ") + quoted(slides, names);
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
    const Limbs limbs = limbs_of(near.conflicts, names);
    text += "; in each other's way may be " + limbs.text;
    slides.insert(limbs.slides.begin(), limbs.slides.end());
  }
  return {std::move(text), listed(slides), place};
}

Finding off_plane_finding(const std::set<int>& slides, const std::vector<std::string>& names) {
  const bool is_one = slides.size() == 1;
  return {"the cage encloses the model, but " + sections_of(slides, names) +
              (is_one ? " could not stay in its plane and near to square: move or turn this slide, or add one beside it"
                      : " could not stay in their planes and near to square: move or turn these slides, or add one "
                        "beside them"),
          listed(slides),
          {},
          true};
}

Finding too_large_finding(double ratio, const Vector3& place, const std::set<int>& slides,
                          const std::vector<std::string>& names) {
  std::string text = "the cage is " + number(ratio) +
                     " times as large as the model: let sections leave their slides' planes (enclose.in_plane=false), "
                     "or add slides where it stands off";
  if (!slides.empty()) text += ", farthest near " + quoted(slides, names);
  return {std::move(text), listed(slides), place, true};
}

Finding merged_finding(const SlidePairs& limbs, const std::vector<int>& lost, const std::vector<std::string>& names) {
  auto [text, slides] = limbs_of(limbs, names);
  text = "the cages of " + text + " run into each other and were made one there";
  if (!lost.empty()) text += ", which took away " + sections_of({lost.begin(), lost.end()}, names);
  text += ": move or turn these slides, or add one beside them, to keep them apart";
  slides.insert(lost.begin(), lost.end());
  return {std::move(text), listed(slides), {}, true};
}

}  // namespace cagewright
