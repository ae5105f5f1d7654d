// SPDX-License-Identifier: BSD-3-Clause
#include "core/enclose/arrangement.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>

#include "core/enclose/triangle_intersection.h"
#include "core/enclose/triangle_meetings.h"
#include "core/mesh/predicates.h"

namespace cagewright {
namespace {

using Segment = std::pair<int, int>;

// The projection along the axis of the largest part of the normal that does not flatten the triangle.
Projection projection_of(const Triangle3& t) {
  const Vector3 n = (t[1] - t[0]).cross(t[2] - t[0]).cwiseAbs();
  std::array<int, 3> axes = {0, 1, 2};
  std::stable_sort(axes.begin(), axes.end(), [&](int a, int b) { return n[a] > n[b]; });
  for (const int axis : axes) {
    const Projection plane{(axis + 1) % 3, (axis + 2) % 3};
    const auto flat = [&](const Vector3& p) { return Vector2(p[plane.u], p[plane.v]); };
    const int turn = orient2d(flat(t[0]), flat(t[1]), flat(t[2]));
    if (turn > 0) return plane;
    if (turn < 0) return {plane.v, plane.u};
  }
  return {};
}

// The traces in one triangle, and its border, cut at all their common points.
class FaceCuts {
 public:
  FaceCuts(ExactPoints& points, Projection plane, const std::array<int, 3>& corners, const Traces& traces)
      : points_(points), plane_(plane), on_face_(traces.points) {
    std::set<Segment> all = traces.segments;
    for (std::size_t i = 0; i < 3; ++i) all.insert(std::minmax(corners[i], corners[(i + 1) % 3]));
    on_face_.insert(corners.begin(), corners.end());
    segments_.assign(all.begin(), all.end());
    on_segment_.resize(segments_.size());
    for (std::size_t i = 0; i < segments_.size(); ++i)
      boxes_.push_back(box_of(segments_[i].first, segments_[i].second));
  }

  void find() {
    for (std::size_t i = 0; i < segments_.size(); ++i)
      for (std::size_t j = i + 1; j < segments_.size(); ++j) cross(i, j);
    for (std::size_t i = 0; i < segments_.size(); ++i) add_points_on(i);
  }

  const std::set<int>& points() const { return on_face_; }
  // Between neighbouring points.
  std::set<Segment> pieces() const {
    std::set<Segment> all;
    for (std::size_t i = 0; i < segments_.size(); ++i) {
      std::vector<int> stops(on_segment_[i].begin(), on_segment_[i].end());
      stops.push_back(segments_[i].first);
      stops.push_back(segments_[i].second);
      std::sort(stops.begin(), stops.end(), [&](int a, int b) {
        for (int axis = 0; axis < 3; ++axis)
          if (const int side = points_.compare(a, b, axis); side != 0) return side < 0;
        return false;
      });
      for (std::size_t k = 0; k + 1 < stops.size(); ++k) all.insert(std::minmax(stops[k], stops[k + 1]));
    }
    return all;
  }

 private:
  using Box2 = Eigen::AlignedBox2d;

  Vector2 flat(int p) const { return {points_.rounded(p)[plane_.u], points_.rounded(p)[plane_.v]}; }
  Box2 box_of(int a, int b) const {
    Box2 box(flat(a));
    box.extend(flat(b));
    const double slack = 1e-14 * std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
    box.min().array() -= slack;
    box.max().array() += slack;
    return box;
  }

  void cross(std::size_t i, std::size_t j) {
    const auto [a, b] = segments_[i];
    const auto [c, d] = segments_[j];
    if (!boxes_[i].intersects(boxes_[j]) || a == c || a == d || b == c || b == d) return;
    const int of_c = points_.orientation(a, b, c, plane_), of_d = points_.orientation(a, b, d, plane_);
    if (of_c * of_d >= 0) return;
    if (points_.orientation(c, d, a, plane_) * points_.orientation(c, d, b, plane_) >= 0) return;
    const int p = points_.meet_line(a, b, c, d, plane_);
    on_face_.insert(p);
    on_segment_[i].insert(p);
    on_segment_[j].insert(p);
  }

  void add_points_on(std::size_t i) {
    const auto [a, b] = segments_[i];
    for (const int p : on_face_)
      if (p != a && p != b && boxes_[i].contains(flat(p)) && on_segment_[i].count(p) == 0 &&
          points_.orientation(a, b, p, plane_) == 0 && points_.is_between(p, a, b))
        on_segment_[i].insert(p);
  }

  ExactPoints& points_;
  Projection plane_;
  std::set<int> on_face_;
  std::vector<Segment> segments_;
  std::vector<std::set<int>> on_segment_;
  std::vector<Box2> boxes_;
};

void add_faces(const FaceTriangulation& triangulation, int source, std::vector<Arrangement::Face>& faces) {
  std::map<Segment, std::pair<int, std::size_t>> owner;
  const auto first = static_cast<int>(faces.size());
  for (const std::array<int, 3>& t : triangulation.triangles()) {
    Arrangement::Face face;
    face.points = t;
    face.source = source;
    for (std::size_t i = 0; i < 3; ++i) {
      face.is_constrained[i] = triangulation.is_constrained(t[i], t[(i + 1) % 3]);
      owner[{t[i], t[(i + 1) % 3]}] = {static_cast<int>(faces.size()), i};
    }
    faces.push_back(face);
  }
  for (auto f = static_cast<std::size_t>(first); f < faces.size(); ++f)
    for (std::size_t i = 0; i < 3; ++i) {
      const auto found = owner.find({faces[f].points[(i + 1) % 3], faces[f].points[i]});
      faces[f].neighbours[i] = found == owner.end() ? -1 : found->second.first;
    }
}

}  // namespace

Arrangement arrange(const IndexedMesh& mesh) {
  Arrangement result(mesh);
  for (Eigen::Index s = 0; s < mesh.triangles.rows(); ++s) {
    const Triangle3 corners = triangle_of(mesh, s);
    std::array<int, 3> numbers{};
    if (!is_degenerate(corners))
      for (int i = 0; i < 3; ++i) numbers[static_cast<std::size_t>(i)] = result.points.of_row(mesh.triangles(s, i));
    result.corners.push_back(numbers);
    result.planes.push_back(projection_of(corners));
  }
  const std::vector<Traces> traces = TriangleMeetings(mesh, result).find();
  for (std::size_t s = 0; s < result.corners.size(); ++s) {
    result.first_face.push_back(static_cast<int>(result.faces.size()));
    const auto& corners = result.corners[s];
    if (corners[0] == corners[1]) continue;
    FaceCuts cuts(result.points, result.planes[s], corners, traces[s]);
    cuts.find();
    FaceTriangulation triangulation(result.points, result.planes[s], corners);
    for (const int p : cuts.points()) triangulation.insert(p);
    for (const auto& [a, b] : cuts.pieces()) triangulation.constrain(a, b);
    add_faces(triangulation, static_cast<int>(s), result.faces);
  }
  result.first_face.push_back(static_cast<int>(result.faces.size()));
  return result;
}

}  // namespace cagewright
