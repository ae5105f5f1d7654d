// SPDX-License-Identifier: BSD-3-Clause
#include "core/enclose/movable_cage.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/enclose/triangle_distance.h"
#include "core/mesh/tolerance.h"

namespace cagewright {
namespace {

bool meet(const Triangle3& model_triangle, const Triangle3& cage_triangle) {
  if (is_degenerate(cage_triangle)) return true;
  if (!is_degenerate(model_triangle)) return triangles_meet(model_triangle, cage_triangle);
  for (std::size_t i = 0; i < 3; ++i)
    if (segment_meets_triangle(model_triangle[i], model_triangle[(i + 1) % 3], cage_triangle)) return true;
  return false;
}

}  // namespace

MovableCage::MovableCage(const Segmentation& segmentation, const Cage& cage, double diagonal)
    : segmentation_(segmentation),
      cage_(cage),
      tree_(segmentation.cut),
      mesh_{cage.points, cage.triangles},
      incident_(static_cast<std::size_t>(cage.points.rows())),
      looked_beyond_(tolerance::looked_beyond * diagonal),
      neighbourhoods_(static_cast<std::size_t>(cage.triangles.rows())),
      last_hit_(static_cast<std::size_t>(cage.triangles.rows()), -1) {
  for (int t = 0; t < triangle_count(); ++t)
    for (int i = 0; i < 3; ++i) incident_[static_cast<std::size_t>(vertex_of(t, i))].push_back(t);
  find_balls();
  find_parts_beyond();
  place_all(cage.points);
}

void MovableCage::find_balls() {
  constexpr double up = 1 + 1e-6;
  for (Eigen::Index k = 0; k < model().triangles.rows(); ++k) {
    const Triangle3 t = triangle_of(model(), k);
    const Eigen::Vector3f center = ((t[0] + t[1] + t[2]) / 3).cast<float>();
    double squared = 0;
    for (const Vector3& p : t) squared = std::max(squared, (p - center.cast<double>()).squaredNorm());
    balls_.push_back({center, static_cast<float>(std::sqrt(squared) * up), static_cast<int>(k)});
  }
}

void MovableCage::look_round(int t, double reach) const {
  Neighbourhood& around = neighbourhoods_[static_cast<std::size_t>(t)];
  around.at = triangle(t);
  around.reach = reach;
  around.moved = 0;
  around.has_plane = !is_thin(around.at, box(t));
  around.balls.clear();
  tree_.visit_near(around.at, reach, [&](int k) {
    around.balls.push_back(balls_[static_cast<std::size_t>(k)]);
    return false;
  });
  if (!around.has_plane) return;
  const Vector3 n = unit_normal(around.at);
  for (Ball& ball : around.balls) ball.height = static_cast<float>(n.dot(ball.center.cast<double>() - around.at[0]));
  std::sort(around.balls.begin(), around.balls.end(), [](const Ball& a, const Ball& b) {
    const float a_top = a.height + a.radius, b_top = b.height + b.radius;
    return a_top != b_top ? a_top > b_top : a.triangle < b.triangle;
  });
}

const MovableCage::Neighbourhood& MovableCage::neighbourhood(int t, double distance) const {
  constexpr double stale = 0.4;  // share of the reach: having moved more, a new look is worth its while
  Neighbourhood& around = neighbourhoods_[static_cast<std::size_t>(t)];
  if (around.reach >= 0) {
    const Triangle3 now = triangle(t);
    around.moved = 0;
    for (std::size_t i = 0; i < 3; ++i) around.moved = std::max(around.moved, (now[i] - around.at[i]).norm());
  }
  if (around.reach < 0 || around.moved + distance > around.reach || around.moved > stale * around.reach)
    look_round(t, distance + looked_beyond_);
  return around;
}

void MovableCage::visit_near(int t, double distance, const std::function<bool(int)>& visit) const {
  constexpr double single_rounding = 1e-6;
  const Triangle3 now = triangle(t);
  const Box3& bounds = box(t);
  const Prism prism(now, bounds);
  const double slack = distance + tolerance::rounding * now[0].cwiseAbs().maxCoeff();
  const Neighbourhood& around = neighbourhood(t, distance);
  // The triangle is still within `moved` of its old plane.
  const float slab =
      static_cast<float>((around.moved + slack + single_rounding * around.reach) * (1 + single_rounding));
  for (const Ball& ball : around.balls) {
    if (around.has_plane) {
      if (ball.height + ball.radius < -slab) break;
      if (ball.height - ball.radius > slab) continue;
    }
    const Vector3 center = ball.center.cast<double>();
    const double reach = slack + static_cast<double>(ball.radius);
    if (prism.parts_ball(center, reach)) continue;
    if (bounds.squaredExteriorDistance(center) > reach * reach) continue;
    if (visit(ball.triangle)) return;
  }
}

void MovableCage::find_parts_beyond() {
  first_beyond_.assign(1, 0);
  for (std::size_t k = 0; k < segmentation_.triangle_part.size(); ++k) {
    const auto part = static_cast<std::size_t>(segmentation_.triangle_part[k]);
    const Triangle3 corners = triangle_of(segmentation_.cut, static_cast<Eigen::Index>(k));
    const Vector3 middle = (corners[0] + corners[1] + corners[2]) / 3;
    for (const PartSection& side : segmentation_.parts[part].sections) {
      const Ellipse& slide = segmentation_.ellipses[static_cast<std::size_t>(side.slide)];
      if ((middle - slide.center).norm() < tolerance::near_slide * slide.u.norm())
        parts_beyond_.push_back(segmentation_.slide_parts[static_cast<std::size_t>(side.slide)][side.outward ? 1 : 0]);
    }
    first_beyond_.push_back(static_cast<int>(parts_beyond_.size()));
  }
}

std::span<const int> MovableCage::parts_beyond(int model_triangle) const {
  const auto k = static_cast<std::size_t>(model_triangle);
  return {parts_beyond_.data() + first_beyond_[k], static_cast<std::size_t>(first_beyond_[k + 1] - first_beyond_[k])};
}

Vector3 MovableCage::normal(int t) const { return unit_normal(triangle(t)); }

double MovableCage::volume() const {
  double six = 0;
  for (int t = 0; t < triangle_count(); ++t) {
    const Triangle3 c = triangle(t);
    six += (c[0] - point(0)).dot((c[1] - point(0)).cross(c[2] - point(0)));
  }
  return six / 6;
}

Vector3 MovableCage::volume_gradient(int vertex) const {
  Vector3 six = Vector3::Zero();
  for (const int t : triangles_at(vertex)) {
    int i = 0;
    while (vertex_of(t, i) != vertex) ++i;
    const Vector3 b = point(vertex_of(t, (i + 1) % 3)), c = point(vertex_of(t, (i + 2) % 3));
    six += (b - point(vertex)).cross(c - point(vertex));
  }
  return six / 6;
}

void MovableCage::place(int vertex, const Vector3& point) {
  mesh_.points.row(vertex) = point.transpose();
  for (const int t : triangles_at(vertex)) boxes_[static_cast<std::size_t>(t)] = box_of_triangle(mesh_, t);
}

void MovableCage::place_all(const Points& points) {
  mesh_.points = points;
  boxes_.clear();
  for (int t = 0; t < triangle_count(); ++t) boxes_.push_back(box_of_triangle(mesh_, t));
}

bool MovableCage::is_own(int t, int model_triangle) const {
  const int wall_part = cage_.triangle_part[static_cast<std::size_t>(t)];
  if (segmentation_.triangle_part[static_cast<std::size_t>(model_triangle)] == wall_part) return true;
  const auto beyond = parts_beyond(model_triangle);
  return std::find(beyond.begin(), beyond.end(), wall_part) != beyond.end();
}

bool MovableCage::is_asked(int t, int model_triangle, Whose whose) const {
  if (whose == Whose::nobody) return false;
  return whose == Whose::any || is_own(t, model_triangle) == (whose == Whose::own);
}

void MovableCage::visit_hits(int t, Whose whose, double clearance, const std::function<bool(int)>& visit) const {
  const Triangle3 corners = triangle(t);
  const Prism prism(corners, box(t));
  int& last = last_hit_[static_cast<std::size_t>(t)];
  visit_near(t, clearance, [&](int k) {
    const Triangle3 model_triangle = triangle_of(model(), k);
    if (clearance > 0) {
      if (prism.parts(model_triangle, clearance) ||
          plane_parts(model_triangle, unit_normal(model_triangle), corners, clearance))
        return false;
      if (!are_nearer_than(model_triangle, corners, clearance) && !meet(model_triangle, corners)) return false;
    } else if (!meet(model_triangle, corners)) {
      return false;
    }
    if (!is_asked(t, k, whose)) return false;
    last = k;
    return visit(k);
  });
}

int MovableCage::hit_of_model(int t, Whose whose, double clearance) const {
  const int last = last_hit_[static_cast<std::size_t>(t)];
  if (last >= 0 && meet(triangle_of(model(), last), triangle(t)) && is_asked(t, last, whose)) return last;
  int found = -1;
  visit_hits(t, whose, clearance, [&](int k) {
    found = k;
    return true;
  });
  return found;
}

bool MovableCage::are_in_the_way(int t, int other, double gap) const {
  const auto corners = mesh_.triangles.row(t), others = mesh_.triangles.row(other);
  bool shares = false;
  for (int i = 0; i < 3; ++i) shares = shares || (others.array() == corners(i)).any();
  const Triangle3 a = triangle(t), b = triangle(other);
  if (!shares && gap > 0) {
    if (plane_parts(a, unit_normal(a), b, gap) || plane_parts(b, unit_normal(b), a, gap)) return false;
    if (are_nearer_than(a, b, gap)) return true;
  }
  // A triangle without area meets what it meets by its edges; it is in the way wherever boxes meet.
  if (is_degenerate(a) || is_degenerate(b)) return true;
  return triangles_of_mesh_meet(mesh_, t, other);
}

void MovableCage::visit_cage_hits(int t, double gap, const std::function<bool(int)>& visit) const {
  Box3 reach = box(t);
  reach.min().array() -= gap;
  reach.max().array() += gap;
  for (int other = 0; other < triangle_count(); ++other)
    if (other != t && box(other).intersects(reach) && are_in_the_way(t, other, gap) && visit(other)) return;
}

int MovableCage::hit_of_cage(int t, double gap) const {
  int found = -1;
  visit_cage_hits(t, gap, [&](int other) {
    found = other;
    return true;
  });
  return found;
}

}  // namespace cagewright
