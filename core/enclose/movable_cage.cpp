// SPDX-License-Identifier: BSD-3-Clause
#include "core/enclose/movable_cage.h"

#include "core/enclose/triangle_distance.h"
#include "core/mesh/tolerance.h"

namespace cagewright {
namespace {

Triangle3 triangle_of(const IndexedMesh& mesh, Eigen::Index t) {
  const auto corners = mesh.triangles.row(t);
  return {mesh.points.row(corners(0)), mesh.points.row(corners(1)), mesh.points.row(corners(2))};
}

}  // namespace

MovableCage::MovableCage(const Segmentation& segmentation, const Cage& cage, double clearance)
    : segmentation_(segmentation),
      cage_(cage),
      clearance_(clearance),
      tree_(segmentation.cut),
      mesh_{cage.points, cage.triangles},
      incident_(static_cast<std::size_t>(cage.points.rows())),
      part_beyond_(segmentation.triangle_part.size(), -1),
      last_hit_(static_cast<std::size_t>(cage.triangles.rows()), -1) {
  for (int t = 0; t < triangle_count(); ++t)
    for (int i = 0; i < 3; ++i) incident_[static_cast<std::size_t>(mesh_.triangles(t, i))].push_back(t);
  find_parts_beyond();
  place_all(cage.points);
}

void MovableCage::find_parts_beyond() {
  for (std::size_t k = 0; k < part_beyond_.size(); ++k) {
    const auto part = static_cast<std::size_t>(segmentation_.triangle_part[k]);
    const Triangle3 corners = triangle_of(segmentation_.cut, static_cast<Eigen::Index>(k));
    const Vector3 middle = (corners[0] + corners[1] + corners[2]) / 3;
    double nearest = tolerance::near_slide;
    for (const PartSection& side : segmentation_.parts[part].sections) {
      const Ellipse& slide = segmentation_.ellipses[static_cast<std::size_t>(side.slide)];
      const double distance = (middle - slide.center).norm() / slide.u.norm();
      if (distance >= nearest) continue;
      nearest = distance;
      part_beyond_[k] = segmentation_.slide_parts[static_cast<std::size_t>(side.slide)][side.outward ? 1 : 0];
    }
  }
}

Triangle3 MovableCage::triangle(int t) const { return triangle_of(mesh_, t); }

Vector3 MovableCage::normal(int t) const {
  const Triangle3 corners = triangle(t);
  return (corners[1] - corners[0]).cross(corners[2] - corners[0]).stableNormalized();
}

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
    while (mesh_.triangles(t, i) != vertex) ++i;
    const Vector3 b = point(mesh_.triangles(t, (i + 1) % 3)), c = point(mesh_.triangles(t, (i + 2) % 3));
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

bool MovableCage::runs_into(const Triangle3& model_triangle, const Triangle3& cage_triangle) const {
  if (clearance_ > 0 && triangle_distance(model_triangle, cage_triangle) < clearance_) return true;
  if (is_degenerate(cage_triangle)) return true;
  if (!is_degenerate(model_triangle)) return triangles_meet(model_triangle, cage_triangle);
  for (std::size_t i = 0; i < 3; ++i)
    if (segment_meets_triangle(model_triangle[i], model_triangle[(i + 1) % 3], cage_triangle)) return true;
  return false;
}

bool MovableCage::is_asked(int t, int model_triangle, Whose whose) const {
  if (whose == Whose::any) return true;
  const int wall_part = cage_.triangle_part[static_cast<std::size_t>(t)];
  const auto k = static_cast<std::size_t>(model_triangle);
  const bool is_own = segmentation_.triangle_part[k] == wall_part || part_beyond_[k] == wall_part;
  return is_own == (whose == Whose::own);
}

void MovableCage::visit_hits(int t, Whose whose, const std::function<bool(const Triangle3& hit)>& visit) const {
  const Triangle3 corners = triangle(t);
  int& last = last_hit_[static_cast<std::size_t>(t)];
  const auto stops = [&](int k) {
    if (!is_asked(t, k, whose)) return false;
    const Triangle3 model_triangle = triangle_of(segmentation_.cut, k);
    if (!runs_into(model_triangle, corners)) return false;
    last = k;
    return visit(model_triangle);
  };
  tree_.visit_near(corners, clearance_, stops);
}

bool MovableCage::hits_model(int t, Whose whose) const {
  const int last = last_hit_[static_cast<std::size_t>(t)];
  if (last >= 0 && is_asked(t, last, whose) && runs_into(triangle_of(segmentation_.cut, last), triangle(t)))
    return true;
  bool found = false;
  visit_hits(t, whose, [&](const Triangle3&) { return found = true; });
  return found;
}

long MovableCage::count_model_hits(int t, Whose whose) const {
  long count = 0;
  visit_hits(t, whose, [&](const Triangle3&) {
    ++count;
    return false;
  });
  return count;
}

long MovableCage::count_cage_hits(int t) const {
  long count = 0;
  for (int other = 0; other < triangle_count(); ++other)
    count += other != t && boxes_[static_cast<std::size_t>(other)].intersects(boxes_[static_cast<std::size_t>(t)]) &&
             triangles_of_mesh_meet(mesh_, t, other);
  return count;
}

bool MovableCage::hits_cage(int t) const {
  for (int other = 0; other < triangle_count(); ++other)
    if (other != t && boxes_[static_cast<std::size_t>(other)].intersects(boxes_[static_cast<std::size_t>(t)]) &&
        triangles_of_mesh_meet(mesh_, t, other))
      return true;
  return false;
}

}  // namespace cagewright
