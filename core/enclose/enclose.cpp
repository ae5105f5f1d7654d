// SPDX-License-Identifier: BSD-3-Clause
#include "core/enclose/enclose.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <set>
#include <utility>

#include "core/enclose/clearance.h"
#include "core/enclose/find_contacts.h"
#include "core/enclose/flatten.h"
#include "core/enclose/grow_through.h"
#include "core/enclose/merge_limbs.h"
#include "core/enclose/nearest_slide.h"
#include "core/enclose/push_out.h"
#include "core/enclose/start.h"
#include "core/enclose/surface_tree.h"
#include "core/enclose/tighten.h"
#include "core/mesh/tolerance.h"

namespace cagewright {
namespace {

constexpr double degree = std::numbers::pi / 180;
using Whose = MovableCage::Whose;

constexpr double push_share = 0.15, release_share = 0.2, free_share = 0.3, clearance_share = 0.45,
                 merge_share = 0.8;  // of the progress, where they end

Progress part_of(const Progress& progress, double begin, double end) {
  if (!progress) return {};
  return [=](double fraction) { return progress(begin + fraction * (end - begin)); };
}

// How far floats are apart where the model is.
double float_step(const Points& points) { return std::numeric_limits<float>::epsilon() * points.cwiseAbs().maxCoeff(); }

// Whether they can tell the model's walls apart: not beyond their range, nor very far from the origin.
bool floats_hold(const Points& points, double diagonal) {
  const bool in_range = points.cwiseAbs().maxCoeff() < 0.1 * double{std::numeric_limits<float>::max()} &&
                        diagonal > 1e6 * double{std::numeric_limits<float>::min()};
  return in_range && float_step(points) < tolerance::coarsest_float * diagonal;
}

// Everything that the steps of enclosing share.
class Enclosing {
 public:
  Enclosing(const Model& model, const Segmentation& segmentation, const std::vector<SectionFrame>& sections,
            const Cage& cage, const std::vector<std::string>& names, const EncloseOptions& options)
      : model_(model),
        sections_(sections),
        cage_(cage),
        names_(names),
        options_(options),
        movable_(segmentation, cage, model.diagonal),
        shape_(cage, sections, options.in_plane, options.corner_angle * degree),
        owners_(find_vertex_owners(segmentation.cut)),
        neighbours_(segmentation.cut),
        rounds_(options.round_to_float && floats_hold(segmentation.cut.points, model.diagonal)),
        gap_(std::max(tolerance::least_gap * model.diagonal, rounds_ ? 4 * float_step(segmentation.cut.points) : 0)),
        wanted_(std::max(gap_, options.delta * model.diagonal)),
        clearance_(static_cast<std::size_t>(movable_.triangle_count()), gap_) {}

  Enclosure run(const Progress& progress) {
    bool is_clear = begin(shape_, part_of(progress, 0, push_share));
    if (!is_clear && options_.in_plane)
      is_clear = release_stuck(part_of(progress, push_share, release_share)) ||
                 begin_free(part_of(progress, release_share, free_share));
    const Points enclosing = is_clear ? movable_.points() : cage_.points;
    const SectionShape shape = shape_;
    if (is_clear) keep(part_of(progress, free_share, clearance_share));
    double done = is_clear ? clearance_share : free_share;
    if (options_.merge && (!is_clear || lacks_clearance())) {
      const double begin = std::exchange(done, merge_share);
      if (auto merged = merge(is_clear, enclosing, shape, part_of(progress, begin, done))) return std::move(*merged);
    }
    finish(is_clear, part_of(progress, done, 1));
    return std::move(result_);
  }

 private:
  void finish(bool is_clear, const Progress& progress) {
    result_.first_volume = movable_.volume();
    const Points loose = movable_.points();
    if (is_clear && options_.tighten)
      result_.sweeps =
          tighten(movable_, shape_, owners_, {clearance_, gap_, model_.diagonal, options_.threads}, progress);
    judge();
    if (result_.sweeps > 0 && !result_.certificate.encloses()) {  // rounding brought something into the way
      movable_.place_all(loose);
      judge();
    }
  }

  Guard guard_of(Whose whose) const {
    return {whose, clearance_, gap_, std::vector<char>(clearance_.size(), 0), options_.threads};
  }

  bool begin(const SectionShape& shape, const Progress& progress) {
    draw_back(movable_, shape, sections_, guard_of(Whose::others), tolerance::round_the_loop * model_.diagonal);
    const bool is_free = &shape != &shape_ || !options_.in_plane;
    const int most = is_free ? most_pushes : most_pushes_in_plane;
    if (push(shape, gap_, most, Whose::others, part_of(progress, 0, 0.5))) return true;
    // Through other parts' model, too, which their own walls may yet bring in.
    return is_free && push(shape, gap_, most_pushes, Whose::nobody, part_of(progress, 0.5, 1));
  }

  // Where sections in plane get stuck: without those that hold what is stuck, where they are few.
  bool release_stuck(const Progress& progress) {
    const Points stuck = movable_.points();
    SectionShape some(shape_);
    if (2 * let_go_stuck(some) <= some.section_count()) {
      movable_.place_all(cage_.points);
      draw_back(movable_, some, sections_, guard_of(Whose::others), tolerance::round_the_loop * model_.diagonal);
      if (push(some, gap_, most_pushes_released, Whose::others, part_of(progress, 0, 0.5))) {
        flatten(movable_, shape_, some, owners_, guard_of(Whose::any), model_.diagonal, part_of(progress, 0.5, 1));
        return true;
      }
    }
    movable_.place_all(stuck);
    return false;
  }

  // How many.
  int let_go_stuck(SectionShape& shape) const {
    const Outside outside = find_outside(movable_, neighbours_, gap_, options_.threads);
    int count = 0;
    for (int t = 0; t < movable_.triangle_count(); ++t) {
      if (outside.meeting[static_cast<std::size_t>(t)].empty()) continue;
      for (int i = 0; i < 3; ++i)
        if (const int k = shape.section_of(movable_.vertex_of(t, i)); k >= 0 && !shape.is_released(k)) {
          shape.release(k);
          ++count;
        }
    }
    return count;
  }

  // Where that does not do: all free first, then as many as can be into their planes.
  bool begin_free(const Progress& progress) {
    const Points stuck = movable_.points();
    movable_.place_all(cage_.points);
    const SectionShape free(cage_, sections_, false, 0);
    if (begin(free, part_of(progress, 0, 0.5))) {
      flatten(movable_, shape_, free, owners_, guard_of(Whose::any), model_.diagonal, part_of(progress, 0.5, 1));
      return true;
    }
    movable_.place_all(stuck);
    return false;
  }

  bool lacks_clearance() const {
    return options_.delta > 0 && *std::min_element(clearance_.begin(), clearance_.end()) < wanted_;
  }

  // The cage with limbs made one, where that encloses the model and, unless nothing else does, keeps the clearance;
  // in plane, if that will do. It begins from `from`, which encloses the model where `is_clear`.
  std::optional<Enclosure> merge(bool is_clear, const Points& from, const SectionShape& shape,
                                 const Progress& progress) {
    const Points before = movable_.points();
    const SectionShape free(cage_, sections_, false, 0);
    std::optional<Enclosure> result;
    for (const SectionShape* held : {&shape, &free}) {
      // Where not even free walls enclose the model, those in plane need not be tried.
      if (result || (held == &shape && !(options_.in_plane && is_clear))) continue;
      const double begin = held == &shape ? 0 : 0.5;
      Points points = from;
      held->put_in_shape(points);
      movable_.place_all(points);
      result_.pushes += grow_through(movable_, *held, neighbours_, owners_, options_of_push(wanted_ + gap_ / 2),
                                     part_of(progress, begin, begin + 0.2));
      result = take_merged(is_clear, part_of(progress, begin + 0.2, begin + 0.5));
    }
    movable_.place_all(before);
    return result;
  }

  std::optional<Enclosure> take_merged(bool is_clear, const Progress& progress) {
    std::optional<MergedLimbs> limbs;
    try {
      limbs = merge_limbs(movable_, {wanted_, gap_, rounds_});
    } catch (const Error& error) {
      if (error.code() != ErrorCode::internal) throw;
    }
    // Walls whose hull cannot be told: the cage stays as it is, with its own sentence.
    if (!limbs || limbs->cage.triangles.rows() == 0) return {};
    Enclosing merged(model_, movable_.segmentation(), sections_, limbs->cage, names_, options_);
    merged.finish_merged(limbs->slides, result_.pushes, progress);
    const Enclosure& reached = merged.result_;
    if (!reached.certificate.encloses() || !(reached.keeps_delta || !is_clear)) return {};
    return std::move(merged.result_);
  }

  void finish_merged(const std::vector<std::pair<int, int>>& limbs, int pushes, const Progress& progress) {
    limbs_merged_ = limbs;
    result_.pushes = pushes;
    for (int k = 0; k < shape_.section_count(); ++k)
      if (!shape_.is_released(k) && !is_in_place(k)) shape_.release(k);
    const bool is_clear = push(shape_, gap_, most_pushes_in_plane, Whose::any, part_of(progress, 0, 0.2));
    if (is_clear) keep(part_of(progress, 0.2, 0.5));
    finish(is_clear, part_of(progress, 0.5, 1));
    result_.merged = cage_;
    result_.merged->points = result_.points;
  }

  bool is_in_place(int section) const {
    const SectionFrame& frame = sections_[static_cast<std::size_t>(section)];
    for (int i = 0; i < 4; ++i)
      if (std::abs(frame.normal.dot(movable_.point(shape_.corner(section, i)) - frame.center)) >
          tolerance::least_gap * model_.diagonal)
        return false;
    return shape_.is_sound(section, movable_.points());
  }

  PushOptions options_of_push(double clearance) const {
    PushOptions push;
    push.clearance = clearance;
    push.gap = gap_;
    push.diagonal = model_.diagonal;
    push.threads = options_.threads;
    return push;
  }

  bool push(const SectionShape& shape, double clearance, int most, Whose guarded, const Progress& progress) {
    PushOptions push = options_of_push(clearance);
    push.most = most;
    if (most < most_pushes) push.patience = patience_in_plane;
    push.guarded = guarded;
    const int steps = push_out(movable_, shape, neighbours_, owners_, push, progress);
    result_.pushes += steps;
    return steps < most;
  }

  void keep(const Progress& progress) {
    if (options_.delta <= 0 || wanted_ <= gap_) return;
    const ClearanceOptions options{wanted_ + gap_ / 2, gap_, model_.diagonal, options_.in_plane, options_.threads};
    Clearance clearance = keep_clearance(movable_, shape_, neighbours_, owners_, options, progress);
    clearance_ = std::move(clearance.kept);
    result_.pushes += clearance.pushes;
  }

  void judge() {
    if (rounds_) {
      const Points rounded = movable_.points().cast<float>().cast<double>();
      movable_.place_all(rounded);
    }
    result_.points = movable_.points();
    result_.certificate = certify(to_indexed_mesh(model_.mesh), {result_.points, cage_.triangles}, options_.threads);
    result_.sections_off_plane.clear();
    result_.sections_merged.clear();
    for (int k = 0; k < shape_.section_count(); ++k)
      if (!shape_.is_whole(k))
        result_.sections_merged.push_back(k);
      else if (options_.in_plane && shape_.is_released(k))
        result_.sections_off_plane.push_back(k);
    result_.most_off_square = shape_.most_off(result_.points) / degree;
    judge_clearance();
    result_.findings = findings();
    result_.shortfall = sentences_of(result_.findings);
  }

  void judge_clearance() {
    too_near_ = {};
    result_.least_distance = wanted_;
    if (options_.delta > 0) {
      const double rounding = std::numeric_limits<float>::epsilon() * wanted_;
      const std::vector<double> kept = distances_kept(movable_, wanted_ - rounding, options_.threads);
      too_near_ = find_too_near(movable_, kept, wanted_ - rounding);
      if (!too_near_.slides.empty()) {
        const auto least = std::min_element(kept.begin(), kept.end());
        result_.least_distance = *least;
        nearest_place_ = middle_of(static_cast<int>(least - kept.begin()));
      }
    }
    result_.keeps_delta = too_near_.slides.empty() && result_.certificate.encloses();
  }

  void add_slides(int t, std::map<int, int>& slides) const {
    const auto part = static_cast<std::size_t>(cage_.triangle_part[static_cast<std::size_t>(t)]);
    for (const PartSection& side : movable_.segmentation().parts[part].sections) ++slides[side.slide];
  }

  // Those with the most failures.
  static std::set<int> worst(const std::map<int, int>& slides) {
    std::vector<std::pair<int, int>> order;  // failures, falling, and slide
    for (const auto& [k, count] : slides) order.emplace_back(-count, k);
    std::sort(order.begin(), order.end());
    std::set<int> named;
    for (std::size_t i = 0; i < order.size() && i < most_named; ++i) named.insert(order[i].second);
    return named;
  }

  std::vector<Finding> findings_of_certified() const {
    std::vector<Finding> findings;
    if (!too_near_.slides.empty())
      findings.push_back(too_near_finding(too_near_, result_.least_distance / model_.diagonal, nearest_place_, names_));
    const std::set<int> released(result_.sections_off_plane.begin(), result_.sections_off_plane.end());
    if (!released.empty()) {
      findings.push_back(off_plane_finding(released, names_));
      if (released.size() == 1) findings.back().place = sections_[static_cast<std::size_t>(*released.begin())].center;
    }
    const double ratio = movable_.volume() / model_.volume;
    if (options_.in_plane && options_.delta <= 0 && shape_.section_count() > 0 && ratio > loose_ratio) {
      const FarthestOff farthest = farthest_off();
      findings.push_back(too_large_finding(ratio, farthest.place, farthest.slides, names_));
    }
    if (!limbs_merged_.empty())
      findings.push_back(merged_finding(limbs_merged_, result_.sections_merged, options_.in_plane, names_));
    return findings;
  }

  struct FarthestOff {
    Vector3 place;
    std::set<int> slides;  // of its part's the nearest; none where the part has none
  };
  // Of the cage's vertices and the middles of its triangles the one that is farthest from the model. O(n log n).
  FarthestOff farthest_off() const {
    const SurfaceTree surface(movable_.model(), options_.threads);
    double most = 0;
    int triangle = 0;
    Vector3 place = middle_of(0);
    const auto look_at = [&](const Vector3& point, int t) {
      const double off = surface.nearest(point).distance;
      if (off > (1 + tolerance::tie) * most) most = off, triangle = t, place = point;
    };
    for (int v = 0; v < movable_.vertex_count(); ++v)
      if (!movable_.triangles_at(v).empty()) look_at(movable_.point(v), movable_.triangles_at(v).front());
    for (int t = 0; t < movable_.triangle_count(); ++t) look_at(middle_of(t), t);
    const Segmentation& segmentation = movable_.segmentation();
    const int part = cage_.triangle_part[static_cast<std::size_t>(triangle)];
    const int slide = nearest_slide(segmentation, slides_of_part(segmentation, part), place);
    return {place, slide < 0 ? std::set<int>() : std::set{slide}};
  }

  std::vector<Finding> findings() const {
    const Certificate& certificate = result_.certificate;
    if (certificate.encloses()) return findings_of_certified();
    std::map<int, int> slides;  // and how many failures each is near
    for (const int t : certificate.degenerate_triangles) add_slides(t, slides);
    for (const auto& [s, t] : certificate.self_intersections) {
      add_slides(s, slides);
      add_slides(t, slides);
    }
    for (const auto& [t, wall] : certificate.model_cage_intersections) add_slides(wall, slides);
    const std::set<int> named = worst(slides);
    Finding finding =
        not_enclosing_finding(certificate, named, named.size() == slides.size(), options_.in_plane, names_);
    finding.place = place_of_failure();
    return {finding};
  }

  std::optional<Vector3> place_of_failure() const {
    const Certificate& certificate = result_.certificate;
    if (!certificate.vertices_outside.empty())
      return Vector3(to_indexed_mesh(model_.mesh).points.row(certificate.vertices_outside.front()));
    int wall = -1;
    if (!certificate.model_cage_intersections.empty())
      wall = certificate.model_cage_intersections.front()[1];
    else if (!certificate.self_intersections.empty())
      wall = certificate.self_intersections.front()[0];
    if (wall < 0) return {};
    return middle_of(wall);
  }

  Vector3 middle_of(int t) const {
    return (movable_.point(movable_.vertex_of(t, 0)) + movable_.point(movable_.vertex_of(t, 1)) +
            movable_.point(movable_.vertex_of(t, 2))) /
           3;
  }

  static constexpr double loose_ratio = 2.5;  // of volumes
  static constexpr int most_pushes = 60, most_pushes_in_plane = 24, most_pushes_released = 20, patience_in_plane = 8;
  static constexpr std::size_t most_named = 4;  // slides, in a sentence

  const Model& model_;
  const std::vector<SectionFrame>& sections_;
  const Cage& cage_;
  const std::vector<std::string>& names_;
  const EncloseOptions& options_;
  MovableCage movable_;
  SectionShape shape_;
  std::vector<int> owners_;
  VertexNeighbours neighbours_;
  bool rounds_;                                    // to floats in the end
  double gap_, wanted_;                            // model units
  TooNear too_near_;                               // in the end
  Vector3 nearest_place_ = Vector3::Zero();        // where it is nearest, if too near
  std::vector<double> clearance_;                  // of each cage triangle: what it keeps
  std::vector<std::pair<int, int>> limbs_merged_;  // slides
  Enclosure result_;
};

}  // namespace

Enclosure enclose(const Model& model, const Segmentation& segmentation, const std::vector<SectionFrame>& sections,
                  const Cage& cage, const std::vector<std::string>& names, const EncloseOptions& options,
                  const Progress& progress) {
  return Enclosing(model, segmentation, sections, cage, names, options).run(progress);
}

}  // namespace cagewright
