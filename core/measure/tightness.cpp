// SPDX-License-Identifier: BSD-3-Clause
#include "core/measure/tightness.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "core/measure/surface_samples.h"
#include "core/mesh/inspect.h"
#include "core/parallel/parallel_for.h"

namespace cagewright {
namespace {

constexpr std::size_t most_samples = 200000;

struct Gaps {
  double sum = 0, least = std::numeric_limits<double>::infinity(), most = 0;
};

// Of each cage triangle by itself, so that hints, and with them the last bits, do not depend on who did the one before.
std::vector<Gaps> find_gaps(const SurfaceTree& surface, const SurfaceSamples& samples, unsigned threads) {
  std::vector<Gaps> gaps(samples.triangles());
  parallel_for(gaps.size(), threads, [&](std::size_t t) {
    int hint = 0;
    for (std::size_t k = 0; k < samples.points_each(); ++k) {
      const auto [distance, place] = surface.nearest(samples.point(t, k), hint);
      hint = place;
      gaps[t].sum += distance;
      gaps[t].least = std::min(gaps[t].least, distance);
      gaps[t].most = std::max(gaps[t].most, distance);
    }
  });
  return gaps;
}

double find_clearance(const SurfaceTree& surface, const IndexedMesh& cage, double bound, unsigned threads) {
  std::vector<double> least(static_cast<std::size_t>(cage.triangles.rows()));
  parallel_for(least.size(), threads, [&](std::size_t t) {
    const auto corners = cage.triangles.row(static_cast<Eigen::Index>(t));
    least[t] = surface.distance({cage.points.row(corners(0)), cage.points.row(corners(1)), cage.points.row(corners(2))},
                                bound);
  });
  return *std::min_element(least.begin(), least.end());
}

double find_coverage(const MeasuredModel& model, const std::vector<int>& outside) {
  double share = 0;
  for (const int v : outside) share += model.vertex_share(v);
  return std::max(0.0, 1 - share);
}

}  // namespace

Tightness measure_tightness(const MeasuredModel& model, const IndexedMesh& cage, const Certificate& certificate,
                            unsigned threads) {
  const MeshReport report = inspect(cage);
  const IndexedMesh scaled = model.to_units(cage);
  const SurfaceSamples samples(scaled, most_samples);

  Tightness result;
  double nearest = std::numeric_limits<double>::infinity();
  const std::vector<Gaps> gaps = find_gaps(model.surface(), samples, threads);
  for (std::size_t t = 0; t < gaps.size(); ++t) {
    result.mean_gap += samples.share(t) * gaps[t].sum / static_cast<double>(samples.points_each());
    result.max_gap = std::max(result.max_gap, gaps[t].most);
    nearest = std::min(nearest, gaps[t].least);
  }
  if (certificate.model_cage_intersections.empty())
    result.clearance = find_clearance(model.surface(), scaled, nearest, threads);
  if (report.closed() && report.consistently_oriented()) {
    result.volume_ratio = signed_volume(scaled) / model.volume();
    result.coverage = find_coverage(model, certificate.vertices_outside);
  }
  return result;
}

}  // namespace cagewright
