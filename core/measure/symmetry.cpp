// SPDX-License-Identifier: BSD-3-Clause
#include "core/measure/symmetry.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "core/measure/surface_samples.h"
#include "core/mesh/tolerance.h"
#include "core/parallel/parallel_for.h"

namespace cagewright {
namespace {

constexpr std::size_t most_model_samples = 8192;
constexpr std::size_t most_cage_samples = 50000;

Vector3 mirrored(const Vector3& point, const Vector3& on_plane, const Vector3& normal) {
  return point - 2 * normal.dot(point - on_plane) * normal;
}

// An axis whose moment is another's, too, is one of many, and which one is chance.
std::vector<Vector3> candidates(const Eigen::Matrix3d& covariance) {
  std::vector<Vector3> normals = {Vector3::UnitX(), Vector3::UnitY(), Vector3::UnitZ()};
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> principal(covariance);
  const Vector3 moments = principal.eigenvalues();  // ascending
  const auto differ = [&](int i) {
    return i < 0 || i > 1 || moments[i + 1] - moments[i] > tolerance::same_moment * moments[i + 1];
  };
  for (int axis = 0; axis < 3; ++axis)
    if (differ(axis - 1) && differ(axis)) normals.push_back(principal.eigenvectors().col(axis));
  return normals;
}

// Empty as soon as it is known to exceed the tolerance: most candidates are far off, and end after a few points.
std::optional<double> deviation_in(const MeasuredModel& model, const SurfaceSamples& samples, const Vector3& normal) {
  double sum = 0;
  int hint = 0;
  for (std::size_t t = 0; t < samples.triangles(); ++t)
    for (std::size_t k = 0; k < samples.points_each(); ++k) {
      const Vector3 image = mirrored(samples.point(t, k), model.centroid(), normal);
      const auto [distance, place] = model.surface().nearest(image, hint);
      hint = place;
      sum += samples.share(t) * distance / static_cast<double>(samples.points_each());
      if (sum > tolerance::mirror) return {};
    }
  return sum;
}

}  // namespace

std::vector<MirrorPlane> find_mirror_planes(const MeasuredModel& model, unsigned threads) {
  const std::vector<Vector3> normals = candidates(model.covariance());
  const SurfaceSamples samples(model.mesh(), most_model_samples);
  std::vector<std::optional<double>> deviations(normals.size());
  parallel_for(normals.size(), threads,
               [&](std::size_t i) { deviations[i] = deviation_in(model, samples, normals[i]); });

  std::vector<MirrorPlane> planes;
  for (std::size_t i = 0; i < normals.size(); ++i) {
    const auto is_same = [&](const MirrorPlane& plane) {
      return std::abs(plane.normal.dot(normals[i])) > tolerance::same_mirror;
    };
    if (!deviations[i] || std::any_of(planes.begin(), planes.end(), is_same)) continue;
    planes.push_back({model.to_model(model.centroid()), normals[i], *deviations[i]});
  }
  return planes;
}

std::optional<Asymmetry> measure_asymmetry(const MeasuredModel& model, const std::vector<MirrorPlane>& planes,
                                           const IndexedMesh& cage, unsigned threads) {
  if (planes.empty()) return {};
  const IndexedMesh scaled = model.to_units(cage);
  const SurfaceTree surface(scaled, threads);
  const SurfaceSamples samples(scaled, most_cage_samples);
  Asymmetry worst{0, 0};
  for (const MirrorPlane& plane : planes) {
    std::vector<Asymmetry> found(samples.triangles(), {0, 0});
    parallel_for(found.size(), threads, [&](std::size_t t) {
      int hint = 0;
      for (std::size_t k = 0; k < samples.points_each(); ++k) {
        const auto [distance, place] =
            surface.nearest(mirrored(samples.point(t, k), model.centroid(), plane.normal), hint);
        hint = place;
        found[t].mean += samples.share(t) * distance / static_cast<double>(samples.points_each());
        found[t].max = std::max(found[t].max, distance);
      }
    });
    Asymmetry here{0, 0};
    for (const Asymmetry& part : found) here = {here.mean + part.mean, std::max(here.max, part.max)};
    worst = {std::max(worst.mean, here.mean), std::max(worst.max, here.max)};
  }
  return worst;
}

}  // namespace cagewright
