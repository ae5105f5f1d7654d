// SPDX-License-Identifier: BSD-3-Clause
#include "core/enclose/find_contacts.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/enclose/triangle_distance.h"
#include "core/mesh/tolerance.h"
#include "core/parallel/parallel_for.h"

namespace cagewright {
namespace {

constexpr int fields = 5;     // along each side of a triangle
constexpr double coarse = 3;  // longest edge of a model triangle over the reach: beyond, vertices do not tell

struct Near {
  double distance = std::numeric_limits<double>::infinity();
  Vector3 weights, from;  // the point on the cage triangle, the model's point
};

class TriangleContacts {
 public:
  TriangleContacts(const MovableCage& movable, int t, double clearance)
      : movable_(movable),
        t_(t),
        clearance_(clearance),
        corners_(movable.triangle(t)),
        prism_(corners_, movable.box(t)),
        near_(fields * fields) {}

  void offer_point(const Vector3& p, double reach) {
    if (prism_.parts_ball(p, reach)) return;
    const Vector3 weights = nearest_on_triangle(p, corners_);
    const double distance = (at_barycentric(corners_, weights) - p).norm();
    if (distance <= reach) offer({distance, weights, p});
  }
  void offer_triangle(const Triangle3& other, double reach) {
    if (prism_.parts(other, reach) || plane_parts(other, unit_normal(other), corners_, reach)) return;
    const NearestPoints nearest = nearest_points(corners_, other);
    if (nearest.distance <= reach) offer({nearest.distance, nearest.on_s, at_barycentric(other, nearest.on_t)});
  }
  void finish() {
    for (const Near& near : near_)
      if (std::isfinite(near.distance)) add(near);
  }
  Contacts found;

 private:
  void offer(const Near& candidate) {
    const auto field = [](double share) { return std::min(fields - 1, static_cast<int>(share * fields)); };
    Near& near = near_[static_cast<std::size_t>(field(candidate.weights[1]) * fields + field(candidate.weights[2]))];
    if (candidate.distance < near.distance) near = candidate;
  }
  void add(const Near& near) {
    const Vector3 apart = at_barycentric(corners_, near.weights) - near.from;
    const double size = std::max(near.from.norm(), 1e-300);
    const Vector3 n = near.distance > tolerance::rounding * size ? Vector3(apart / near.distance) : movable_.normal(t_);
    found.push_back(contact_of(movable_, t_, near.weights, n, clearance_ - near.distance));
  }

  const MovableCage& movable_;
  int t_;
  double clearance_;
  Triangle3 corners_;
  Prism prism_;
  std::vector<Near> near_;
};

double longest_edge(const Triangle3& t) {
  return std::sqrt(std::max({(t[1] - t[0]).squaredNorm(), (t[2] - t[1]).squaredNorm(), (t[0] - t[2]).squaredNorm()}));
}

Contacts model_contacts(const MovableCage& movable, const std::vector<int>& owner, int t, const ContactQuery& query) {
  const double clearance = query.clearance[static_cast<std::size_t>(t)], reach = clearance + query.longest;
  TriangleContacts contacts(movable, t, clearance);
  const IndexedMesh& model = movable.model();
  const auto meets = [&](int k) {
    if (!query.outside) return false;
    for (int i = 0; i < 3; ++i)
      if ((*query.outside)[static_cast<std::size_t>(model.triangles(k, i))]) return true;
    const std::vector<int>& all = (*query.meeting)[static_cast<std::size_t>(t)];
    return std::binary_search(all.begin(), all.end(), k);
  };
  movable.visit_near(t, reach, [&](int k) {
    const Triangle3 corners = triangle_of(model, k);
    for (int i = 0; i < 3; ++i) {
      const auto v = static_cast<std::size_t>(model.triangles(k, i));
      if (owner[v] == k && !(query.outside && (*query.outside)[v]))
        contacts.offer_point(corners[static_cast<std::size_t>(i)], reach);
    }
    if (longest_edge(corners) > coarse * reach && !meets(k)) contacts.offer_triangle(corners, reach);
    return false;
  });
  for (auto hit = std::lower_bound(query.hits.begin(), query.hits.end(), std::pair(t, 0));
       hit != query.hits.end() && hit->first == t; ++hit)
    if (!meets(hit->second)) contacts.offer_triangle(triangle_of(model, hit->second), 2 * reach);
  contacts.finish();
  return std::move(contacts.found);
}

class CagePairs {
 public:
  CagePairs(const MovableCage& movable, const ContactQuery& query)
      : movable_(movable), gap_(query.gap), reach_(query.gap + 2 * query.longest) {}

  void find(int s) {
    Box3 box = movable_.box(s);
    box.min().array() -= reach_;
    box.max().array() += reach_;
    for (int t = s + 1; t < movable_.triangle_count(); ++t)
      if (movable_.box(t).intersects(box)) look_at(s, t);
  }
  Contacts found;

 private:
  void look_at(int s, int t) {
    const auto& triangles = movable_.mesh().triangles;
    int shared = 0, s_corner = 0, t_corner = 0;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        if (triangles(s, i) == triangles(t, j)) {
          ++shared;
          s_corner = i;
          t_corner = j;
        }
    const Triangle3 a = movable_.triangle(s), b = movable_.triangle(t);
    if (shared == 0) add(s, a, t, b, gap_);
    if (shared != 1) return;
    // Beyond a shared vertex: the edges opposite to it.
    add(s, opposite(a, s_corner), t, b, 0, s_corner);
    add(t, opposite(b, t_corner), s, a, 0, t_corner);
  }
  static Triangle3 opposite(const Triangle3& t, int corner) {
    const auto i = static_cast<std::size_t>((corner + 1) % 3), j = static_cast<std::size_t>((corner + 2) % 3);
    Triangle3 edge = t;
    edge[static_cast<std::size_t>(corner)] = t[i];
    static_cast<void>(j);
    return edge;
  }
  // `moved`: the corner of s that stands for the next one, as of an edge, or -1.
  void add(int s, const Triangle3& a, int t, const Triangle3& b, double gap, int moved = -1) {
    const NearestPoints nearest = nearest_points(a, b);
    if (!(nearest.distance <= reach_) || !(nearest.distance > 0)) return;
    const Vector3 n = (at_barycentric(b, nearest.on_t) - at_barycentric(a, nearest.on_s)) / nearest.distance;
    Contact contact;
    contact.least = gap - nearest.distance;
    for (int i = 0; i < 3; ++i) {
      const int corner = i == moved ? (i + 1) % 3 : i;
      if (nearest.on_s[i] > 0) contact.add(movable_.vertex_of(s, corner), -nearest.on_s[i] * n);
    }
    for (int i = 0; i < 3; ++i)
      if (nearest.on_t[i] > 0) contact.add(movable_.vertex_of(t, i), nearest.on_t[i] * n);
    found.push_back(contact);
  }

  const MovableCage& movable_;
  double gap_, reach_;
};

}  // namespace

std::vector<int> find_vertex_owners(const IndexedMesh& model) {
  std::vector<int> owner(static_cast<std::size_t>(model.points.rows()), -1);
  for (Eigen::Index k = model.triangles.rows() - 1; k >= 0; --k)
    for (int i = 0; i < 3; ++i) owner[static_cast<std::size_t>(model.triangles(k, i))] = static_cast<int>(k);
  return owner;
}

Contact contact_of(const MovableCage& movable, int t, const Vector3& weights, const Vector3& n, double least) {
  Contact contact;
  contact.least = least;
  for (int i = 0; i < 3; ++i)
    if (weights[i] > 0) contact.add(movable.vertex_of(t, i), weights[i] * n);
  return contact;
}

Contacts find_contacts(const MovableCage& movable, const std::vector<int>& vertex_owner, const ContactQuery& query) {
  const auto count = static_cast<std::size_t>(movable.triangle_count());
  std::vector<Contacts> of_triangle(count);
  parallel_for(count, query.threads, [&](std::size_t t) {
    of_triangle[t] = model_contacts(movable, vertex_owner, static_cast<int>(t), query);
    CagePairs pairs(movable, query);
    pairs.find(static_cast<int>(t));
    of_triangle[t].insert(of_triangle[t].end(), pairs.found.begin(), pairs.found.end());
  });
  Contacts all;
  for (const Contacts& contacts : of_triangle) all.insert(all.end(), contacts.begin(), contacts.end());
  return all;
}

}  // namespace cagewright
