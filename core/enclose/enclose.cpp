// SPDX-License-Identifier: BSD-3-Clause
#include "core/enclose/enclose.h"

#include <set>

#include "core/enclose/movable_cage.h"
#include "core/enclose/push_out.h"
#include "core/enclose/tighten.h"

namespace cagewright {
namespace {

constexpr int most_pushes = 30;
constexpr double push_share = 0.1, untangle_share = 0.2;  // of the progress

Progress part_of(const Progress& progress, double begin, double end) {
  if (!progress) return {};
  return [=](double fraction) { return progress(begin + fraction * (end - begin)); };
}

Points plane_normals_of(const Cage& cage, const std::vector<SectionFrame>& sections, bool in_plane) {
  Points normals = Points::Zero(cage.points.rows(), 3);
  if (!in_plane) return normals;
  for (std::size_t v = 0; v < cage.vertex_section.size(); ++v)
    if (const int k = cage.vertex_section[v]; k >= 0)
      normals.row(static_cast<Eigen::Index>(v)) = sections[static_cast<std::size_t>(k)].normal.transpose();
  return normals;
}

// The slides of the parts whose cage triangles fail.
std::string slides_at_fault(const Segmentation& segmentation, const Cage& cage, const std::vector<std::string>& names,
                            const Certificate& certificate) {
  std::set<int> slides;
  const auto add = [&](int t) {
    const auto part = static_cast<std::size_t>(cage.triangle_part[static_cast<std::size_t>(t)]);
    for (const PartSection& side : segmentation.parts[part].sections) slides.insert(side.slide);
  };
  for (const int t : certificate.degenerate_triangles) add(t);
  for (const auto& [s, t] : certificate.self_intersections) {
    add(s);
    add(t);
  }
  for (const auto& [t, wall] : certificate.model_cage_intersections) add(wall);
  std::string text;
  for (const int k : slides) text += (text.empty() ? "'" : ", '") + names[static_cast<std::size_t>(k)] + "'";
  return text;
}

std::string shortfall_of(const Segmentation& segmentation, const Cage& cage, const std::vector<std::string>& names,
                         const Certificate& certificate, bool keeps_delta) {
  if (certificate.encloses() && keeps_delta) return "";
  if (!keeps_delta && certificate.encloses())
    return "the cage encloses the model, but not with the distance asked for everywhere: ask for less (refine.delta), "
           "or "
           "add slides where limbs are close to each other";
  const std::string slides = slides_at_fault(segmentation, cage, names, certificate);
  std::string text = "the cage could not be made to enclose the model: ";
  text += std::to_string(certificate.self_intersections.size()) + " pairs of its triangles cross each other, " +
          std::to_string(certificate.model_cage_intersections.size()) + " model triangles cross it, " +
          std::to_string(certificate.vertices_outside.size()) + " model vertices are outside";
  return text +
         (slides.empty() ? "; add slides" : "; move or turn one of the slides " + slides + ", or add one between them");
}

}  // namespace

Enclosure enclose(const Model& model, const Segmentation& segmentation, const std::vector<SectionFrame>& sections,
                  const Cage& cage, const std::vector<std::string>& names, const EncloseOptions& options,
                  const Progress& progress) {
  MovableCage movable(segmentation, cage, options.delta * model.diagonal);
  const Points planes = plane_normals_of(cage, sections, options.in_plane);
  Enclosure result;
  result.pushes = push_out(movable, segmentation, cage, planes, model.diagonal, options, most_pushes,
                           part_of(progress, 0, push_share));
  const bool is_clear = untangle(movable, planes, model.diagonal, part_of(progress, push_share, untangle_share)) &&
                        result.pushes < most_pushes;
  if (is_clear && options.tighten)
    result.sweeps = tighten(movable, planes, model.diagonal, part_of(progress, untangle_share, 1));
  result.points = movable.points();
  result.certificate = certify(to_indexed_mesh(model.mesh), {result.points, cage.triangles}, options.threads);
  result.keeps_delta = true;
  for (int t = 0; t < movable.triangle_count() && result.keeps_delta; ++t)
    result.keeps_delta = !movable.hits_model(t, MovableCage::Whose::any);
  result.shortfall = shortfall_of(segmentation, cage, names, result.certificate, result.keeps_delta);
  return result;
}

}  // namespace cagewright
