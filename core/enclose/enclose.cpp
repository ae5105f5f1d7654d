// SPDX-License-Identifier: BSD-3-Clause
#include "core/enclose/enclose.h"

#include <algorithm>
#include <iomanip>
#include <limits>
#include <numbers>
#include <set>
#include <sstream>

#include "core/enclose/find_contacts.h"
#include "core/enclose/flatten.h"
#include "core/enclose/push_out.h"
#include "core/enclose/start.h"
#include "core/enclose/tighten.h"
#include "core/mesh/tolerance.h"

namespace cagewright {
namespace {

constexpr double degree = std::numbers::pi / 180;
using Whose = MovableCage::Whose;

constexpr double push_share = 0.15, free_share = 0.3, clearance_share = 0.45;  // of the progress, where they end

Progress part_of(const Progress& progress, double begin, double end) {
  if (!progress) return {};
  return [=](double fraction) { return progress(begin + fraction * (end - begin)); };
}

std::string quoted(const std::set<int>& slides, const std::vector<std::string>& names) {
  std::string text;
  for (const int k : slides) text += (text.empty() ? "'" : ", '") + names[static_cast<std::size_t>(k)] + "'";
  return text;
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
        gap_(std::max(tolerance::least_gap * model.diagonal,
                      4 * std::numeric_limits<float>::epsilon() * segmentation.cut.points.cwiseAbs().maxCoeff())),
        wanted_(std::max(gap_, options.delta * model.diagonal)),
        clearance_(static_cast<std::size_t>(movable_.triangle_count()), gap_) {}

  Enclosure run(const Progress& progress) {
    bool is_clear = begin(shape_, part_of(progress, 0, push_share));
    if (!is_clear && options_.in_plane) is_clear = begin_free(part_of(progress, push_share, free_share));
    if (is_clear) keep_clearance(part_of(progress, free_share, clearance_share));
    result_.first_volume = movable_.volume();
    const Points loose = movable_.points();
    if (is_clear && options_.tighten)
      result_.sweeps = tighten(movable_, shape_, owners_, {clearance_, gap_, model_.diagonal, options_.threads},
                               part_of(progress, clearance_share, 1));
    judge();
    if (result_.sweeps > 0 && !result_.certificate.encloses()) {  // rounding brought something into the way
      movable_.place_all(loose);
      judge();
    }
    return std::move(result_);
  }

 private:
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

  // Where sections in plane get stuck: first free, then as many as can be into their planes.
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

  bool push(const SectionShape& shape, double clearance, int most, Whose guarded, const Progress& progress) {
    PushOptions push;
    push.clearance = clearance;
    push.gap = gap_;
    push.diagonal = model_.diagonal;
    push.most = most;
    if (most == most_pushes_in_plane) push.patience = patience_in_plane;
    push.threads = options_.threads;
    push.guarded = guarded;
    const int steps = push_out(movable_, shape, neighbours_, owners_, push, progress);
    result_.pushes += steps;
    return steps < most;
  }

  // Little by little, since walls that turn make room for others. What does not get it all keeps what it has.
  void keep_clearance(const Progress& progress) {
    constexpr int stages = 4, most_at_stage = 12;
    if (wanted_ <= gap_) return;
    for (int stage = 1; stage <= stages; ++stage)
      push(shape_, gap_ + (wanted_ - gap_) * stage / stages, most_at_stage, Whose::any,
           part_of(progress, (stage - 1.0) / stages, static_cast<double>(stage) / stages));
    for (int t = 0; t < movable_.triangle_count(); ++t)
      for (int share = finest; share > 0; --share) {
        const double tried = share == finest ? wanted_ : wanted_ * share / finest;
        if (tried <= gap_ || movable_.hits_model(t, Whose::any, tried)) continue;
        clearance_[static_cast<std::size_t>(t)] = tried;
        break;
      }
  }

  void judge() {
    if (options_.round_to_float) {
      const Points rounded = movable_.points().cast<float>().cast<double>();
      movable_.place_all(rounded);
    }
    result_.points = movable_.points();
    result_.certificate = certify(to_indexed_mesh(model_.mesh), {result_.points, cage_.triangles}, options_.threads);
    result_.sections_off_plane.clear();
    for (int k = 0; options_.in_plane && k < shape_.section_count(); ++k)
      if (shape_.is_released(k)) result_.sections_off_plane.push_back(k);
    result_.most_off_square = shape_.most_off(result_.points) / degree;
    std::set<int> near;
    result_.least_distance = wanted_;
    const double rounding = std::numeric_limits<float>::epsilon() * wanted_;
    for (int t = 0; t < movable_.triangle_count(); ++t) {
      if (options_.delta <= 0 || !movable_.hits_model(t, Whose::any, wanted_ - rounding)) continue;
      add_slides(t, near);
      result_.least_distance = std::min(result_.least_distance, clearance_[static_cast<std::size_t>(t)]);
    }
    result_.keeps_delta = near.empty() && result_.certificate.encloses();
    result_.shortfall = shortfall(near);
  }

  void add_slides(int t, std::set<int>& slides) const {
    const auto part = static_cast<std::size_t>(cage_.triangle_part[static_cast<std::size_t>(t)]);
    for (const PartSection& side : movable_.segmentation().parts[part].sections) slides.insert(side.slide);
  }

  std::string shortfall_of_certified(const std::set<int>& near) const {
    std::ostringstream text;
    if (!near.empty())
      text << std::setprecision(3)
           << "the cage encloses the model, but not with the distance asked for everywhere; where "
           << "it does not it keeps " << result_.least_distance / model_.diagonal << " of the diagonal: ask for less "
           << "(refine.delta), or move limbs apart or add slides where they are close to each other, near "
           << quoted(near, names_);
    const std::set<int> released(result_.sections_off_plane.begin(), result_.sections_off_plane.end());
    if (!released.empty())
      text << (near.empty() ? "" : "; ") << "the cage encloses the model, but the sections of the slides "
           << quoted(released, names_)
           << " could not stay in their planes and near to square: move or turn these slides, "
           << "or add one beside them";
    return text.str();
  }

  std::string shortfall(const std::set<int>& near) const {
    const Certificate& certificate = result_.certificate;
    if (certificate.encloses()) return shortfall_of_certified(near);
    std::set<int> slides;
    for (const int t : certificate.degenerate_triangles) add_slides(t, slides);
    for (const auto& [s, t] : certificate.self_intersections) {
      add_slides(s, slides);
      add_slides(t, slides);
    }
    for (const auto& [t, wall] : certificate.model_cage_intersections) add_slides(wall, slides);
    std::string text = "the cage could not be made to enclose the model: ";
    text += std::to_string(certificate.self_intersections.size()) + " pairs of its triangles cross each other, " +
            std::to_string(certificate.model_cage_intersections.size()) + " model triangles cross it, " +
            std::to_string(certificate.vertices_outside.size()) + " model vertices are outside; ";
    if (slides.empty()) return text + "add slides";
    text += "move or turn one of the slides " + quoted(slides, names_) + ", or add one between them";
    return text + (options_.in_plane ? ", or let sections leave their slides' planes (enclose.in_plane=false)" : "");
  }

  static constexpr int most_pushes = 60, most_pushes_in_plane = 24, patience_in_plane = 8, finest = 20;

  const Model& model_;
  const std::vector<SectionFrame>& sections_;
  const Cage& cage_;
  const std::vector<std::string>& names_;
  const EncloseOptions& options_;
  MovableCage movable_;
  SectionShape shape_;
  std::vector<int> owners_;
  VertexNeighbours neighbours_;
  double gap_, wanted_;            // model units
  std::vector<double> clearance_;  // of each cage triangle: what it keeps
  Enclosure result_;
};

}  // namespace

Enclosure enclose(const Model& model, const Segmentation& segmentation, const std::vector<SectionFrame>& sections,
                  const Cage& cage, const std::vector<std::string>& names, const EncloseOptions& options,
                  const Progress& progress) {
  return Enclosing(model, segmentation, sections, cage, names, options).run(progress);
}

}  // namespace cagewright
