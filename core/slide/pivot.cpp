// SPDX-License-Identifier: BSD-3-Clause
#include "core/slide/pivot.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "core/error/error.h"
#include "core/mesh/tolerance.h"
#include "core/mesh/triangle.h"
#include "core/slide/slide.h"

namespace cagewright {
namespace {

using OpenMesh::FaceHandle;
using OpenMesh::HalfedgeHandle;

constexpr double smoothed = 0.05;         // about the point, over the model's radius: bumps so small do not count
constexpr double inside_triangle = 1e-6;  // least barycentric coordinate of the point that planes turn about

Triangle3 corners_of(const HalfEdgeMesh& mesh, FaceHandle face) {
  const HalfedgeHandle h = mesh.halfedge_handle(face);
  return {mesh.point(mesh.from_vertex_handle(h)), mesh.point(mesh.to_vertex_handle(h)),
          mesh.point(mesh.to_vertex_handle(mesh.next_halfedge_handle(h)))};
}

Vector3 longest_edge(const Triangle3& t) {
  Vector3 longest = t[1] - t[0];
  for (const Vector3& edge : {Vector3(t[2] - t[1]), Vector3(t[0] - t[2])})
    if (edge.norm() > (1 + tolerance::tie) * longest.norm()) longest = edge;
  return longest;
}

// The surface's normal about the pivot, by area, of the triangles that are joined to its own within the radius: those
// farther away count less, and at the radius not at all.
Vector3 normal_about(const HalfEdgeMesh& mesh, const Pivot& pivot, double radius) {
  Vector3 sum = Vector3::Zero();
  std::vector<bool> seen(mesh.n_faces(), false);
  std::vector<FaceHandle> stack = {pivot.face};
  seen[static_cast<std::size_t>(pivot.face.idx())] = true;
  while (!stack.empty()) {
    const FaceHandle face = stack.back();
    stack.pop_back();
    const Triangle3 t = corners_of(mesh, face);
    const double share = ((t[0] + t[1] + t[2]) / 3 - pivot.point).norm() / radius;
    if (share >= 1 && face != pivot.face) continue;
    sum += std::max(1 - share * share, tolerance::tie) * (t[1] - t[0]).cross(t[2] - t[0]);
    for (const auto neighbour : mesh.ff_range(face)) {
      if (seen[static_cast<std::size_t>(neighbour.idx())]) continue;
      seen[static_cast<std::size_t>(neighbour.idx())] = true;
      stack.push_back(neighbour);
    }
  }
  return sum.stableNormalized();
}

}  // namespace

Pivot find_pivot(const HalfEdgeMesh& mesh, const Vector3& point, const std::string& name) {
  Pivot pivot;
  Eigen::AlignedBox3d box;
  for (const auto v : mesh.vertices()) box.extend(mesh.point(v));
  pivot.diagonal = box.diagonal().norm();
  const double tie = tolerance::tie * pivot.diagonal;  // at an edge, rounding must not choose between its triangles
  double least = std::numeric_limits<double>::infinity(), area = 0;
  Vector3 moment = Vector3::Zero();
  for (const auto face : mesh.faces()) {
    const Triangle3 t = corners_of(mesh, face);
    const double twice_area = (t[1] - t[0]).cross(t[2] - t[0]).norm();
    area += twice_area;
    moment += twice_area * ((t[0] - point) + (t[1] - point) + (t[2] - point)) / 3;
    Eigen::AlignedBox3d own(t[0]);
    own.extend(t[1]).extend(t[2]);
    if (own.exteriorDistance(point) >= least - tie) continue;
    if (!(twice_area > tolerance::tie * longest_edge(t).squaredNorm())) continue;  // it has no normal
    const double distance = (at_barycentric(t, nearest_on_triangle(point, t)) - point).norm();
    if (distance >= least - tie) continue;
    least = distance;
    pivot.face = face;
  }
  if (!(least <= tolerance::off_surface * pivot.diagonal))
    throw Error(ErrorCode::slide_misses_model, slide_text(name) + ": its point " + to_text(point) +
                                                   " is not on the model; put it on the surface of the limb to cut");
  const Triangle3 t = corners_of(mesh, pivot.face);
  const Vector3 weights = nearest_on_triangle(point, t).cwiseMax(inside_triangle);
  pivot.point = at_barycentric(t, weights / weights.sum());
  pivot.along = longest_edge(t).normalized();
  pivot.middle = point + moment / area;
  double reach = 0;  // unlike the diagonal, it turns with the model
  for (const auto v : mesh.vertices()) reach = std::max(reach, (mesh.point(v) - pivot.middle).norm());
  pivot.normal = normal_about(mesh, pivot, smoothed * reach);
  return pivot;
}

}  // namespace cagewright
