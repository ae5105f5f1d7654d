// SPDX-License-Identifier: BSD-3-Clause
// From where a place on the active mesh can be seen.
#include <algorithm>
#include <cstddef>
#include <functional>
#include <vector>

#include "host/view/window/projection.h"
#include "host/view/window/scene_state.h"
#include "host/view/window/scene_view.h"

namespace cagewright::host {
namespace {

using Eigen::Vector3d;

// Of the active mesh's diagonal.
constexpr double kLift = 2e-3;    // from the surface on which the place is
constexpr double kNearby = 0.03;  // triangles whose normals count
constexpr double kSlanted = 0.2;  // cosine between surface and view: less is hardly seen

bool is_hidden(const MeshEntry& entry, const Vector3d& place, const Vector3d& toward_viewer) {
  const Vector3d lifted = place + kLift * entry.bounds.diagonal().norm() * toward_viewer;
  const Vector3d direction = (entry.from_scene.topLeftCorner<3, 3>() * toward_viewer).stableNormalized();
  return entry.picker->first_hit(transformed(entry.from_scene, lifted), direction).has_value();
}

// The sum over the triangles near the place, by their areas; 0 where there are none.
Vector3d outward(const MeshEntry& entry, const Vector3d& place) {
  const TriangleMesh& mesh = *entry.shown.mesh;
  const double reach = kNearby * entry.bounds.diagonal().norm();
  const double side = entry.to_scene.topLeftCorner<3, 3>().determinant() < 0 ? -1 : 1;
  Vector3d sum = Vector3d::Zero();
  for (std::size_t i = 0; i + 2 < mesh.triangles.size(); i += 3) {
    const auto corner = [&](std::size_t k) {
      return transformed(entry.to_scene, Vector3d(&mesh.points[3 * std::size_t{mesh.triangles[i + k]}]));
    };
    const Vector3d a = corner(0), b = corner(1), c = corner(2);
    if (std::min({(a - place).norm(), (b - place).norm(), (c - place).norm()}) < reach) {
      sum += side * (b - a).cross(c - a);
    }
  }
  return sum;
}

// The 26 of a cube's faces, edges and corners.
std::vector<Vector3d> directions_all_round() {
  std::vector<Vector3d> all;
  for (const double x : {-1.0, 0.0, 1.0}) {
    for (const double y : {-1.0, 0.0, 1.0}) {
      for (const double z : {-1.0, 0.0, 1.0}) {
        if (x != 0 || y != 0 || z != 0) all.push_back(Vector3d(x, y, z).normalized());
      }
    }
  }
  return all;
}

}  // namespace

std::optional<Point3> SceneView::direction_to_see(const Point3& place) const {
  const MeshEntry* active = state_->active();
  if (active == nullptr || active->is_flat || active->bounds.isEmpty() || !state_->options.model) return std::nullopt;
  const Projection now(state_->renderer);
  const Vector3d at = transformed(active->to_scene, to_vector(place));
  const Vector3d toward_viewer = now.is_orthographic ? Vector3d(-now.forward) : Vector3d((now.eye - at).normalized());
  const Vector3d normal = outward(*active, at);
  const bool is_slanted = normal.dot(toward_viewer) < kSlanted * normal.norm();
  if (!is_slanted && !is_hidden(*active, at, toward_viewer)) return std::nullopt;
  const Vector3d wanted = normal.norm() > 0 ? Vector3d(normal.stableNormalized()) : toward_viewer;
  std::vector<Vector3d> directions = directions_all_round();
  directions.push_back(wanted);
  std::ranges::stable_sort(directions, std::ranges::greater(), [&](const Vector3d& it) { return it.dot(wanted); });
  const auto free = std::ranges::find_if(directions, [&](const Vector3d& it) { return !is_hidden(*active, at, it); });
  return free == directions.end() ? std::nullopt : std::optional(to_point(*free));
}

}  // namespace cagewright::host
