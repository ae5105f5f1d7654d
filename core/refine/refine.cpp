// SPDX-License-Identifier: BSD-3-Clause
#include "core/refine/refine.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

#include "core/error/error.h"
#include "core/mesh/tolerance.h"
#include "core/refine/anchors.h"
#include "core/refine/trust_region.h"

namespace cagewright {
namespace {

Points plane_normals(const Cage& cage, const std::vector<SectionFrame>& sections, bool in_plane) {
  Points normals = Points::Zero(cage.points.rows(), 3);
  if (!in_plane) return normals;
  for (std::size_t j = 0; j < cage.vertex_section.size(); ++j)
    if (const int k = cage.vertex_section[j]; k >= 0)
      normals.row(static_cast<Eigen::Index>(j)) = sections[static_cast<std::size_t>(k)].normal.transpose();
  return normals;
}

std::string advice(const Part& part, const std::vector<std::string>& names) {
  std::string slides;
  for (const PartSection& side : part.sections)
    slides += (slides.empty() ? "'" : ", '") + names[static_cast<std::size_t>(side.slide)] + "'";
  if (slides.empty()) return "cut that part by slides";
  return (part.sections.size() == 1 ? "cut the part beyond the slide " : "cut the part between the slides ") + slides +
         " once more";
}

[[noreturn]] void fail_diverged(const Segmentation& segmentation, const Cage& cage,
                                const std::vector<std::string>& names, RefineScope scope, Eigen::Index vertex,
                                const Vector3& from) {
  ErrorPlace place;
  place.element = static_cast<std::size_t>(vertex);
  place.point = from;
  for (Eigen::Index t = 0; t < cage.triangles.rows() && !place.part; ++t)
    if ((cage.triangles.row(t).array() == static_cast<int>(vertex)).any())
      place.part = static_cast<std::size_t>(cage.triangle_part[static_cast<std::size_t>(t)]);
  const Part& part = segmentation.parts[place.part.value_or(0)];
  if (!part.sections.empty()) place.slide = static_cast<std::size_t>(part.sections.front().slide);
  throw Error(ErrorCode::refine_diverged,
              "the refinement drove cage vertex " + std::to_string(vertex) + ", last near " + to_text(from) +
                  ", out of all bounds: " + advice(part, names) +
                  (scope == RefineScope::part ? ", or set refine.scope to local" : ""),
              place);
}

void check_bounded(const Segmentation& segmentation, const Cage& cage, const std::vector<std::string>& names,
                   RefineScope scope, const RefineRecord& record, const Eigen::AlignedBox3d& allowed) {
  for (Eigen::Index j = 0; j < record.after.rows(); ++j)
    if (!allowed.contains(Vector3(record.after.row(j))))
      fail_diverged(segmentation, cage, names, scope, j, record.before.row(j));
}

// More weight for the triangles that have yet to move (7a) than for those that only keep their place (7b).
std::vector<double> push_factors(const RefineRecord& record, double delta, double extent, double push) {
  std::vector<double> factors;
  for (const double d : record.signed_distance)
    factors.push_back(still_moves(d, delta, tolerance::on_plane * extent) ? push : 1);
  return factors;
}

// A size that turns with the model, as the diagonal of an axis-aligned box does not: from the vertex farthest from the
// mean to the vertex farthest from that one. At most the diagonal.
double extent_of(const Points& points) {
  const auto farthest = [&](const Vector3& from) -> Vector3 {
    Eigen::Index row = 0;
    (points.rowwise() - from.transpose()).rowwise().squaredNorm().maxCoeff(&row);
    return points.row(row);
  };
  const Vector3 one = farthest(points.colwise().mean());
  return (farthest(one) - one).norm();
}

// (9), with the extent for D_BB, which is stricter: so the number of steps does not change when the model is turned.
bool meets_equation_9(double max_signed_distance, double delta, double extent) {
  return std::abs(-max_signed_distance - delta) <= tolerance::convergence * extent;
}

std::string shortfall_of(const Segmentation& segmentation, const Cage& cage, const std::vector<std::string>& names,
                         const RefineRecord& last, double delta, double diagonal) {
  const auto worst = std::max_element(last.signed_distance.begin(), last.signed_distance.end());
  const auto triangle = static_cast<std::size_t>(worst - last.signed_distance.begin());
  const Part& part = segmentation.parts[static_cast<std::size_t>(cage.triangle_part[triangle])];
  std::ostringstream sentence;
  sentence << std::setprecision(3) << "the refinement ended before the cage bounds the model as asked: ";
  if (*worst > -delta)
    sentence << "the vertex near " << to_text(Vector3(segmentation.cut.points.row(last.outermost[triangle])))
             << " is still " << (*worst + delta) / diagonal << " of the diagonal from where it has to be; "
             << advice(part, names) << ", allow more steps (refine.iterations)"
             << (delta > 0 ? ", or ask for less distance (refine.delta)" : "");
  else
    sentence << "it is " << (-*worst - delta) / diagonal
             << " of the diagonal looser everywhere; allow more steps (refine.iterations)";
  return sentence.str();
}

}  // namespace

Refinement refine(const Segmentation& segmentation, const std::vector<SectionFrame>& sections, const Cage& cage,
                  double diagonal, const std::vector<std::string>& names, const RefineOptions& options,
                  const Progress& progress) {
  const double delta = options.delta * diagonal;
  Refinement result{cage, {}, 0, extent_of(segmentation.cut.points), false, {}};
  AnchorFinder anchors(segmentation, cage, options, delta, result.extent);
  const Points normals = plane_normals(cage, sections, options.in_plane);
  const Vector3 margin = Vector3::Constant(tolerance::diverged * diagonal);
  const Eigen::AlignedBox3d allowed(segmentation.cut.points.colwise().minCoeff().transpose() - margin,
                                    segmentation.cut.points.colwise().maxCoeff().transpose() + margin);
  for (int k = 0;; ++k) {
    if (progress && !progress(static_cast<double>(k) / std::max(1, options.iterations)))
      throw Error(ErrorCode::cancelled, "cancelled while the cage was refined");
    RefineRecord record;
    record.before = result.cage.points;
    record.plane_normal = normals;
    anchors.find(result.cage.points, record);
    result.max_signed_distance = record.max_signed_distance;
    result.converged = meets_equation_9(record.max_signed_distance, delta, result.extent);
    if (result.converged || k >= options.iterations) {
      if (!result.converged) result.shortfall = shortfall_of(segmentation, cage, names, record, delta, diagonal);
      return result;
    }
    trusted_step(segmentation, cage, push_factors(record, delta, result.extent, options.push), options.damping,
                 tolerance::smallest_anchor_distance * result.extent, record);
    check_bounded(segmentation, cage, names, options.scope, record, allowed);
    result.cage.points = record.after;
    result.records.push_back(std::move(record));
  }
}

}  // namespace cagewright
