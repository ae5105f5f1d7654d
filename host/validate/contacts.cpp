// SPDX-License-Identifier: BSD-3-Clause
#include "host/validate/contacts.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace cagewright::host {
namespace {

using Triangle = std::array<Eigen::Vector3d, 3>;

constexpr int cells = 6;  // a triangle is divided so often along its edges: one model point is kept for each cell

Triangle triangle_at(const PointList& points, const Corners& c) {
  return {points[static_cast<std::size_t>(c[0])], points[static_cast<std::size_t>(c[1])],
          points[static_cast<std::size_t>(c[2])]};
}

Eigen::AlignedBox3d box_of(const Triangle& t) {
  Eigen::AlignedBox3d box(t[0]);
  box.extend(t[1]);
  box.extend(t[2]);
  return box;
}

// Barycentric coordinates of the projection of p into the triangle's plane.
Eigen::Vector3d barycentric(const Triangle& t, const Eigen::Vector3d& normal, const Eigen::Vector3d& p) {
  const double area = (t[1] - t[0]).cross(t[2] - t[0]).dot(normal);
  const double b = (p - t[0]).cross(t[2] - t[0]).dot(normal) / area;
  const double c = (t[1] - t[0]).cross(p - t[0]).dot(normal) / area;
  return {1 - b - c, b, c};
}

struct Facet {
  Corners corners;
  Triangle triangle;
  Eigen::Vector3d normal;
  Eigen::AlignedBox3d box;
};

using Nearest = std::map<int, std::pair<double, Eigen::Vector3d>>;  // by cell: distance and model point

// What is known of the model points near the cage: for each triangle, those under it and those beside it.
class NearPoints {
 public:
  NearPoints(const PointList& cage, const std::vector<Corners>& triangles, double reach)
      : reach_(reach), under_(triangles.size()), beside_(triangles.size()) {
    for (const Corners& corners : triangles) {
      const Triangle t = triangle_at(cage, corners);
      Eigen::AlignedBox3d box = box_of(t);
      box.min().array() -= reach;
      box.max().array() += reach;
      facets_.push_back({corners, t, (t[1] - t[0]).cross(t[2] - t[0]).stableNormalized(), box});
    }
  }

  // A point beyond an edge or corner of every triangle that is nearest to it, as in a valley of the cage, is beside
  // those triangles. Elsewhere the triangles that it lies under bound it.
  void offer(const Eigen::Vector3d& p) {
    candidates_.clear();
    double least = reach_;
    for (std::size_t f = 0; f < facets_.size(); ++f) {
      const Facet& facet = facets_[f];
      if (!facet.box.contains(p)) continue;
      const double depth = (facet.triangle[0] - p).dot(facet.normal);
      if (std::abs(depth) > reach_) continue;
      const Eigen::Vector3d share = barycentric(facet.triangle, facet.normal, p);
      const bool is_under = depth > 0 && share.minCoeff() >= 0;
      const double distance = is_under ? depth : (nearest_point(facet.triangle, p) - p).norm();
      if (is_under) keep(under_[f], cell_of(share), depth, p);
      candidates_.push_back({f, distance, is_under});
      least = std::min(least, distance);
    }
    const auto is_nearest = [&](const Candidate& c) { return c.distance <= least * (1 + 1e-9); };
    if (std::any_of(candidates_.begin(), candidates_.end(),
                    [&](const Candidate& c) { return c.is_under && is_nearest(c); })) {
      return;
    }
    for (const Candidate& c : candidates_) {
      if (!is_nearest(c) || !(c.distance > 0)) continue;
      const Facet& facet = facets_[c.facet];
      keep(beside_[c.facet], cell_of(barycentric(facet.triangle, facet.normal, nearest_point(facet.triangle, p))),
           c.distance, p);
    }
  }

  void append(Contacts& contacts) const {
    for (std::size_t f = 0; f < facets_.size(); ++f) {
      for (const auto& [cell, near] : under_[f]) contacts.behind.push_back({static_cast<int>(f), near.second});
      for (const auto& [cell, near] : beside_[f]) {
        const Eigen::Vector3d axis = (nearest_point(facets_[f].triangle, near.second) - near.second).normalized();
        for (const int corner : facets_[f].corners) contacts.above.push_back({corner, axis, axis.dot(near.second)});
      }
    }
  }

 private:
  struct Candidate {
    std::size_t facet;
    double distance;
    bool is_under;
  };

  static int cell_of(const Eigen::Vector3d& share) {
    const auto of = [](double s) { return std::clamp(static_cast<int>(s * cells), 0, cells - 1); };
    return of(share.y()) * cells + of(share.z());
  }

  static void keep(Nearest& nearest, int cell, double distance, const Eigen::Vector3d& p) {
    const auto [at, is_new] = nearest.try_emplace(cell, distance, p);
    if (!is_new && distance < at->second.first) at->second = {distance, p};
  }

  double reach_;
  std::vector<Facet> facets_;
  std::vector<Nearest> under_, beside_;  // by facet
  std::vector<Candidate> candidates_;    // of one point; kept for its memory
};

bool share_a_vertex(const Corners& a, const Corners& b) {
  return std::any_of(a.begin(), a.end(), [&](int i) { return std::find(b.begin(), b.end(), i) != b.end(); });
}

}  // namespace

Eigen::Vector3d nearest_point(const Triangle& t, const Eigen::Vector3d& p) {
  const Eigen::Vector3d normal = (t[1] - t[0]).cross(t[2] - t[0]).stableNormalized();
  const Eigen::Vector3d share = barycentric(t, normal, p);
  if (share.minCoeff() >= 0) return p - (p - t[0]).dot(normal) * normal;
  Eigen::Vector3d best = t[0];
  for (std::size_t i = 0; i < 3; ++i) {
    const Eigen::Vector3d edge = t[(i + 1) % 3] - t[i];
    const double along = std::clamp((p - t[i]).dot(edge) / edge.squaredNorm(), 0.0, 1.0);
    const Eigen::Vector3d candidate = t[i] + along * edge;
    if ((candidate - p).squaredNorm() < (best - p).squaredNorm()) best = candidate;
  }
  return best;
}

std::optional<Eigen::Vector3d> separating_axis(const Triangle& upper, const Triangle& lower) {
  std::vector<Eigen::Vector3d> axes = {(upper[1] - upper[0]).cross(upper[2] - upper[0]),
                                       (lower[1] - lower[0]).cross(lower[2] - lower[0])};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      axes.push_back((upper[(i + 1) % 3] - upper[i]).cross(lower[(j + 1) % 3] - lower[j]));
  std::optional<Eigen::Vector3d> best;
  double widest = 0;
  for (const Eigen::Vector3d& direction : axes) {
    const Eigen::Vector3d unit = direction.stableNormalized();
    for (const Eigen::Vector3d& axis : {unit, Eigen::Vector3d(-unit)}) {
      double gap = std::numeric_limits<double>::infinity();
      for (const Eigen::Vector3d& a : upper)
        for (const Eigen::Vector3d& b : lower) gap = std::min(gap, axis.dot(a - b));
      if (gap <= widest) continue;
      widest = gap;
      best = axis;
    }
  }
  return best;
}

void keep_apart(const Triangle& model_triangle, const PointList& cage, const Corners& triangle, Contacts& contacts) {
  const auto axis = separating_axis(triangle_at(cage, triangle), model_triangle);
  if (!axis) return;
  const double least =
      std::max({axis->dot(model_triangle[0]), axis->dot(model_triangle[1]), axis->dot(model_triangle[2])});
  for (const int corner : triangle) contacts.above.push_back({corner, *axis, least});
}

void keep_apart(const PointList& cage, const Corners& first, const Corners& second, Contacts& contacts) {
  if (share_a_vertex(first, second)) return;
  const auto axis = separating_axis(triangle_at(cage, first), triangle_at(cage, second));
  if (!axis) return;
  for (const int upper : first)
    for (const int lower : second) contacts.apart.push_back({upper, lower, *axis});
}

Contacts find_contacts(const PointList& model, const PointList& cage, const std::vector<Corners>& triangles,
                       double reach) {
  NearPoints near(cage, triangles, reach);
  for (const Eigen::Vector3d& p : model) near.offer(p);
  Contacts contacts;
  near.append(contacts);
  std::vector<Eigen::AlignedBox3d> boxes;
  for (const Corners& t : triangles) boxes.push_back(box_of(triangle_at(cage, t)));
  for (std::size_t s = 0; s < triangles.size(); ++s) {
    for (std::size_t t = s + 1; t < triangles.size(); ++t) {
      if (boxes[s].exteriorDistance(boxes[t]) <= reach) keep_apart(cage, triangles[s], triangles[t], contacts);
    }
  }
  return contacts;
}

}  // namespace cagewright::host
