// SPDX-License-Identifier: BSD-3-Clause
#include "core/measure/cage_shape.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/mesh/connectivity.h"
#include "core/mesh/weld.h"

namespace cagewright {
namespace {

Vector3 corner(const IndexedMesh& mesh, Eigen::Index t, int i) { return mesh.points.row(mesh.triangles(t, i)); }

Vector3 normal_of(const IndexedMesh& mesh, Eigen::Index t) {
  return (corner(mesh, t, 1) - corner(mesh, t, 0)).cross(corner(mesh, t, 2) - corner(mesh, t, 0));
}

double aspect_of(const IndexedMesh& mesh, Eigen::Index t) {
  double longest = 0, sum = 0;
  for (int i = 0; i < 3; ++i) {
    const double length = (corner(mesh, t, (i + 1) % 3) - corner(mesh, t, i)).norm();
    longest = std::max(longest, length);
    sum += length;
  }
  const double doubled_area = normal_of(mesh, t).norm();
  if (!(doubled_area > 0)) return std::numeric_limits<double>::infinity();
  return longest * sum / (2 * std::numbers::sqrt3 * doubled_area);
}

// Of the two triangles at half-edge h and at its opposite.
std::optional<double> dihedral_at(const IndexedMesh& mesh, int h, int opposite) {
  if (from_vertex(mesh.triangles, h) != to_vertex(mesh.triangles, opposite)) return {};
  const Vector3 here = normal_of(mesh, h / 3).stableNormalized(),
                there = normal_of(mesh, opposite / 3).stableNormalized();
  if (here.isZero() || there.isZero()) return {};
  const Vector3 along =
      (mesh.points.row(to_vertex(mesh.triangles, h)) - mesh.points.row(from_vertex(mesh.triangles, h)))
          .stableNormalized();
  return std::numbers::pi - std::atan2(along.dot(here.cross(there)), here.dot(there));
}

}  // namespace

CageShape measure_shape(const IndexedMesh& cage) {
  WeldedMesh welded = weld(cage);
  IndexedMesh& mesh = welded.mesh;
  CageShape shape;
  const std::vector<int> opposites = find_opposites(connect(welded).edges);
  const double size = mesh.points.cwiseAbs().maxCoeff();
  if (size > 0) mesh.points /= size;  // so that squares neither overflow nor vanish
  for (int h = 0; h < static_cast<int>(opposites.size()); ++h) {
    if (opposites[static_cast<std::size_t>(h)] < h) continue;
    const auto angle = dihedral_at(mesh, h, opposites[static_cast<std::size_t>(h)]);
    if (!angle) continue;
    shape.least_dihedral = std::min(shape.least_dihedral.value_or(*angle), *angle);
    shape.greatest_dihedral = std::max(shape.greatest_dihedral.value_or(*angle), *angle);
  }
  shape.least_aspect = std::numeric_limits<double>::infinity();
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    const double aspect = aspect_of(mesh, t);
    shape.least_aspect = std::min(shape.least_aspect, aspect);
    shape.greatest_aspect = std::max(shape.greatest_aspect, aspect);
  }
  return shape;
}

}  // namespace cagewright
