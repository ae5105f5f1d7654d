// SPDX-License-Identifier: BSD-3-Clause
#include "core/enclose/finding.h"

#include <array>
#include <iomanip>
#include <sstream>

namespace cagewright {
namespace {

constexpr char leave_planes[] = "let sections leave their slides' planes (enclose.in_plane=false), or ";
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

// "the slide 'knee'", and more.
std::string which(const std::set<int>& slides, const std::vector<std::string>& names) {
  return (slides.size() == 1 ? "the slide " : "the slides ") + quoted(slides, names);
}

// "the section of the slide 'knee'", and of more.
std::string sections_of(const std::set<int>& slides, const std::vector<std::string>& names) {
  return (slides.size() == 1 ? "the section of " : "the sections of ") + which(slides, names);
}

struct Counted {
  std::size_t count;
  const char *one, *more;  // what is counted, after its number
};

// What a certificate misses, divided by commas; what it does not miss goes without saying.
std::string missing_text(const Certificate& certificate) {
  const std::array counted = {
      Counted{certificate.degenerate_triangles.size(), " of its triangles has no area",
              " of its triangles have no area"},
      Counted{certificate.self_intersections.size(), " pair of its triangles crosses", " pairs of its triangles cross"},
      Counted{certificate.model_cage_intersections.size(), " triangle of the model crosses it",
              " triangles of the model cross it"},
      Counted{certificate.vertices_outside.size(), " vertex of the model is outside",
              " vertices of the model are outside"}};
  std::string text;
  for (const auto& [count, one, more] : counted)
    if (count > 0) text += (text.empty() ? "" : ", ") + std::to_string(count) + (count == 1 ? one : more);
  return text.empty() ? "it is not closed" : text;
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

Finding not_enclosing_finding(const Certificate& certificate, const std::set<int>& slides, bool are_all, bool in_plane,
                              const std::vector<std::string>& names) {
  std::string text = "the cage could not be made to enclose the model: " + missing_text(certificate) + "; ";
  if (slides.empty())
    text += "add slides";
  else
    text += (are_all ? "that is near " : "most of that is near ") + which(slides, names) +
            (slides.size() == 1 ? ": move or turn it, or add one beside it"
                                : ": move or turn one of them, or add one between them") +
            (in_plane ? ", or let sections leave their slides' planes (enclose.in_plane=false)" : "");
  return {std::move(text), listed(slides), {}};
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
  std::string text = "the cage is " + number(ratio) + " times as large as the model: " + leave_planes +
                     "add slides where it stands off";
  if (!slides.empty()) text += ", farthest near " + quoted(slides, names);
  return {std::move(text), listed(slides), place, true};
}

Finding merged_finding(const SlidePairs& limbs, const std::vector<int>& lost, bool in_plane,
                       const std::vector<std::string>& names) {
  auto [text, slides] = limbs_of(limbs, names);
  text = "the cages of " + text + " run into each other and were made one there";
  if (!lost.empty()) text += ", which took away " + sections_of({lost.begin(), lost.end()}, names);
  text += std::string(": ") + (in_plane ? leave_planes : "") +
          "move or turn these slides, or add one beside them, to keep them apart";
  slides.insert(lost.begin(), lost.end());
  return {std::move(text), listed(slides), {}, true};
}

}  // namespace cagewright
