// SPDX-License-Identifier: BSD-3-Clause
#include "core/enclose/clearance.h"

#include <algorithm>
#include <set>

#include "core/enclose/flatten.h"
#include "core/enclose/nearest_slide.h"
#include "core/enclose/push_out.h"
#include "core/enclose/triangle_distance.h"
#include "core/parallel/parallel_for.h"

namespace cagewright {
namespace {

constexpr int stages = 4, most_at_stage = 12;    // walls that turn make room for others: little by little
constexpr int releases = 3, most_released = 16;  // rounds of letting sections go, steps of each
constexpr int most_short = 3;    // one of so many triangles: where more are too near, there is no room, planes or not
constexpr double gained = 0.02;  // of the distance wanted: less is not worth leaving a plane for

class Clearing {
 public:
  Clearing(MovableCage& movable, SectionShape& shape, const VertexNeighbours& neighbours,
           const std::vector<int>& vertex_owners, const ClearanceOptions& options)
      : movable_(movable),
        shape_(shape),
        free_(shape),
        neighbours_(neighbours),
        owners_(vertex_owners),
        options_(options) {}

  Clearance run(const Progress& progress) {
    const int rounds = stages + releases + 1;
    const auto part = [&](int round) -> Progress {
      if (!progress) return {};
      return [&progress, round, rounds](double fraction) { return progress((round + fraction) / rounds); };
    };
    for (int stage = 1; stage <= stages; ++stage)
      push(options_.gap + (options_.wanted - options_.gap) * stage / stages, most_at_stage, part(stage - 1));
    result_.kept = distances();
    for (int round = 0; round < releases && options_.may_release; ++round)
      if (!release(part(stages + round))) break;
    if (any_released_) {
      const Guard guard{MovableCage::Whose::any, result_.kept, options_.gap, std::vector<char>(result_.kept.size(), 0),
                        options_.threads};
      flatten(movable_, shape_, free_, owners_, guard, options_.diagonal, part(stages + releases));
      result_.kept = distances();
    }
    return std::move(result_);
  }

 private:
  void push(double clearance, int most, const Progress& progress) {
    PushOptions push;
    push.clearance = clearance;
    push.gap = options_.gap;
    push.diagonal = options_.diagonal;
    push.most = most;
    push.threads = options_.threads;
    push.guarded = MovableCage::Whose::any;
    result_.pushes += push_out(movable_, free_, neighbours_, owners_, push, progress);
  }

  std::vector<double> distances() const {
    std::vector<double> found = distances_kept(movable_, options_.wanted, options_.threads);
    for (double& distance : found) distance = std::max(distance, options_.gap);
    return found;
  }

  double lacking(const std::vector<double>& kept) const {
    double sum = 0;
    for (const double distance : kept) sum += options_.wanted - distance;
    return sum;
  }

  // Lets the sections go that hold triangles which are too near; false where there are none or nothing is gained.
  bool release(const Progress& progress) {
    std::set<int> held;
    int count = 0;
    for (int t = 0; t < movable_.triangle_count(); ++t) {
      if (result_.kept[static_cast<std::size_t>(t)] >= options_.wanted) continue;
      ++count;
      for (int i = 0; i < 3; ++i)
        if (const int k = shape_.section_of(movable_.vertex_of(t, i)); k >= 0 && !free_.is_released(k)) held.insert(k);
    }
    if (held.empty() || most_short * count > movable_.triangle_count()) return false;
    const Points before = movable_.points();
    for (const int k : held) free_.release(k);
    push(options_.wanted, most_released, progress);
    std::vector<double> now = distances();
    const auto least = [](const std::vector<double>& kept) { return *std::min_element(kept.begin(), kept.end()); };
    if (least(now) >= least(result_.kept) && lacking(result_.kept) - lacking(now) > gained * options_.wanted) {
      result_.kept = std::move(now);
      any_released_ = true;
      return true;
    }
    for (const int k : held) free_.hold(k);
    movable_.place_all(before);
    return false;
  }

  MovableCage& movable_;
  SectionShape& shape_;
  SectionShape free_;  // without the sections that are let go
  const VertexNeighbours& neighbours_;
  const std::vector<int>& owners_;
  const ClearanceOptions& options_;
  Clearance result_;
  bool any_released_ = false;
};

std::set<int> slides_at(const MovableCage& movable, int t) {
  std::set<int> slides;
  for (int i = 0; i < 3; ++i)
    if (const int k = movable.cage().vertex_section[static_cast<std::size_t>(movable.vertex_of(t, i))]; k >= 0)
      slides.insert(k);
  if (!slides.empty()) return slides;
  const auto part = static_cast<std::size_t>(movable.cage().triangle_part[static_cast<std::size_t>(t)]);
  for (const PartSection& side : movable.segmentation().parts[part].sections) slides.insert(side.slide);
  return slides;
}

}  // namespace

Clearance keep_clearance(MovableCage& movable, SectionShape& shape, const VertexNeighbours& neighbours,
                         const std::vector<int>& vertex_owners, const ClearanceOptions& options,
                         const Progress& progress) {
  return Clearing(movable, shape, neighbours, vertex_owners, options).run(progress);
}

std::vector<double> distances_kept(const MovableCage& movable, double most, unsigned threads) {
  std::vector<double> found(static_cast<std::size_t>(movable.triangle_count()), most);
  parallel_for(found.size(), threads, [&](std::size_t t) {
    const Triangle3 wall = movable.triangle(static_cast<int>(t));
    movable.visit_hits(static_cast<int>(t), MovableCage::Whose::any, most, [&](int k) {
      found[t] = std::min(found[t], triangle_distance(triangle_of(movable.model(), k), wall));
      return false;
    });
  });
  return found;
}

TooNear find_too_near(const MovableCage& movable, const std::vector<double>& kept, double wanted) {
  TooNear found;
  const Segmentation& segmentation = movable.segmentation();
  for (int t = 0; t < movable.triangle_count(); ++t) {
    if (kept[static_cast<std::size_t>(t)] >= wanted) continue;
    const std::set<int> here = slides_at(movable, t);
    found.slides.insert(here.begin(), here.end());
    const std::vector<int> own(here.begin(), here.end());
    std::set<int> others;
    movable.visit_hits(t, MovableCage::Whose::others, 2 * wanted, [&](int k) {
      others.insert(segmentation.triangle_part[static_cast<std::size_t>(k)]);
      return false;
    });
    const Triangle3 corners = movable.triangle(t);
    const Vector3 middle = (corners[0] + corners[1] + corners[2]) / 3;
    for (const int part : others) {
      const std::vector<int> slides = slides_of_part(segmentation, part);
      if (slides.empty()) continue;
      const int a = nearest_slide(segmentation, own, middle), b = nearest_slide(segmentation, slides, middle);
      if (a != b) found.conflicts.emplace(std::min(a, b), std::max(a, b));
    }
  }
  return found;
}

}  // namespace cagewright
