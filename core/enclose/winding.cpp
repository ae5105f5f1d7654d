// SPDX-License-Identifier: BSD-3-Clause
#include "core/enclose/winding.h"

#include "core/enclose/triangle_intersection.h"
#include "core/error/error.h"
#include "core/mesh/predicates.h"

namespace cagewright {
namespace {

struct Crossing {
  bool is_sound = true;  // no vertex, no edge and no end of the ray on a plane
  int sign = 0;          // 1: out, -1: in, 0: none
};

// Of the ray from p to its far end q.
Crossing crossing_of(const Vector3& p, const Vector3& q, const Triangle3& t) {
  if (is_degenerate(t)) return {};
  const int p_side = orient3d(t[0], t[1], t[2], p), q_side = orient3d(t[0], t[1], t[2], q);
  if (p_side * q_side > 0) return {};
  bool left = false, right = false, on_edge = false;
  for (std::size_t i = 0; i < 3; ++i) {
    const int side = orient3d(p, q, t[i], t[(i + 1) % 3]);
    left = left || side > 0;
    right = right || side < 0;
    on_edge = on_edge || side == 0;
  }
  if (left && right) return {};
  if (p_side == 0 || q_side == 0 || on_edge) return {false, 0};
  return {true, q_side};
}

}  // namespace

Winding::Winding(const IndexedMesh& mesh, const BoxTree& tree) : mesh_(mesh), tree_(tree) {
  for (Eigen::Index v = 0; v < mesh.points.rows(); ++v) box_.extend(Vector3(mesh.points.row(v)));
}

std::optional<int> Winding::of(const Vector3& point) const {
  if (!box_.contains(point)) return 0;
  bool is_on_mesh = false;
  tree_.visit(Box3(point), [&](int t) {
    const Triangle3 corners = triangle_of(mesh_, t);
    is_on_mesh = !is_degenerate(corners) && segment_meets_triangle(point, point, corners);
    return is_on_mesh;
  });
  if (is_on_mesh) return {};

  // Nearly along the shortest way out, so that the ray's box is slim; turned a little more after every unlucky ray.
  int axis = 0;
  const Vector3 up = box_.max() - point, down = point - box_.min();
  const double way_up = up.minCoeff(&axis);
  int other = 0;
  const double way_down = down.minCoeff(&other);
  const bool is_up = way_up <= way_down;
  if (!is_up) axis = other;
  const double length = (is_up ? way_up : way_down) + 0.01 * box_.diagonal().stableNorm();
  constexpr int most_rays = 64;
  for (int ray = 0; ray < most_rays; ++ray) {
    Vector3 end = point;
    end[axis] += is_up ? length : -length;
    end[(axis + 1) % 3] += length * (0.00137 + 0.0071 * ray);
    end[(axis + 2) % 3] -= length * (0.00211 + 0.0053 * ray);
    int winding = 0;
    bool is_sound = true;
    Box3 box(point);
    box.extend(end);
    tree_.visit(box, [&](int t) {
      const Crossing crossing = crossing_of(point, end, triangle_of(mesh_, t));
      is_sound = is_sound && crossing.is_sound;
      winding += crossing.sign;
      return !is_sound;
    });
    if (is_sound) return winding;
  }
  throw Error(ErrorCode::internal, "enclose: no ray from " + to_text(point) + " passes all edges of the cage");
}

}  // namespace cagewright
