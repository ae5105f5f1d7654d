// SPDX-License-Identifier: BSD-3-Clause
#include "core/enclose/simplify_hull.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "core/enclose/box_tree.h"

namespace cagewright {
namespace {

constexpr int most_rounds = 12;

double six_volume(const Triangle3& t, const Vector3& origin) {
  return (t[0] - origin).dot((t[1] - origin).cross(t[2] - origin));
}

class Simplifying {
 public:
  Simplifying(const IndexedMesh& mesh, const SimplifyOptions& options)
      : mesh_(mesh),
        options_(options),
        is_alive_(static_cast<std::size_t>(mesh.triangles.rows()), 1),
        at_(static_cast<std::size_t>(mesh.points.rows())) {
    for (int t = 0; t < static_cast<int>(mesh.triangles.rows()); ++t) {
      boxes_.push_back(box_of_triangle(mesh, t));
      for (int i = 0; i < 3; ++i) at(mesh.triangles(t, i)).push_back(t);
    }
  }

  Simplified run() {
    for (int round = 0; round < most_rounds; ++round) {
      std::vector<Collapse> all = find_collapses();
      std::vector<char> is_touched(at_.size(), 0);
      bool any = false;
      for (const Collapse& collapse : all) {
        if (is_touched[index(collapse.keep)] || is_touched[index(collapse.drop)]) continue;
        if (!apply(collapse)) continue;
        any = true;
        is_touched[index(collapse.keep)] = is_touched[index(collapse.drop)] = 1;
        for (const int t : at(collapse.keep))
          for (int i = 0; i < 3; ++i) is_touched[index(mesh_.triangles(t, i))] = 1;
      }
      if (!any) break;
    }
    return result();
  }

 private:
  struct Collapse {
    int keep = 0, drop = 0;
    Vector3 place;
    double cost = 0;
  };

  static std::size_t index(int k) { return static_cast<std::size_t>(k); }
  std::vector<int>& at(int v) { return at_[index(v)]; }
  const std::vector<int>& at(int v) const { return at_[index(v)]; }
  bool has(int t, int v) const { return (mesh_.triangles.row(t).array() == v).any(); }
  Vector3 point(int v) const { return mesh_.points.row(v); }

  std::vector<Collapse> find_collapses() const {
    std::vector<Collapse> all;
    for (int t = 0; t < static_cast<int>(mesh_.triangles.rows()); ++t) {
      if (!is_alive_[index(t)]) continue;
      for (int i = 0; i < 3; ++i) {
        const int a = mesh_.triangles(t, i), b = mesh_.triangles(t, (i + 1) % 3);
        const bool a_fixed = options_.is_fixed[index(a)], b_fixed = options_.is_fixed[index(b)];
        if (a > b || (a_fixed && b_fixed)) continue;
        const int keep = b_fixed ? b : a, drop = b_fixed ? a : b;
        std::vector<Vector3> places = {point(keep)};
        if (!a_fixed && !b_fixed) places.insert(places.end(), {(point(a) + point(b)) / 2, point(drop)});
        for (const Vector3& place : places)
          if (const double cost = std::abs(change(keep, drop, place)); cost <= options_.most_volume)
            all.push_back({keep, drop, place, cost});
      }
    }
    std::stable_sort(all.begin(), all.end(), [](const Collapse& a, const Collapse& b) { return a.cost < b.cost; });
    return all;
  }

  // Of the volume.
  double change(int keep, int drop, const Vector3& place) const {
    double six = 0;
    for (const int v : {keep, drop})
      for (const int t : at(v)) {
        if (v == drop && has(t, keep)) continue;
        Triangle3 corners = triangle_of(mesh_, t);
        six -= six_volume(corners, place);
        for (std::size_t i = 0; i < 3; ++i) {
          const int vertex = mesh_.triangles(t, static_cast<Eigen::Index>(i));
          if (vertex == keep || vertex == drop) corners[i] = place;
        }
        six += six_volume(corners, place);
      }
    return six / 6;
  }

  // Both vertices have no common neighbours but those of the edge's two triangles.
  bool stays_manifold(int keep, int drop) const {
    const auto neighbours = [&](int v) {
      std::set<int> found;
      for (const int t : at(v))
        for (int i = 0; i < 3; ++i) found.insert(mesh_.triangles(t, i));
      found.erase(v);
      return found;
    };
    const std::set<int> of_keep = neighbours(keep), of_drop = neighbours(drop);
    if (of_keep.count(drop) == 0) return false;
    std::vector<int> common;
    std::set_intersection(of_keep.begin(), of_keep.end(), of_drop.begin(), of_drop.end(), std::back_inserter(common));
    return common.size() == 2 && of_keep.size() + of_drop.size() > 7;
  }

  bool apply(const Collapse& collapse) {
    const auto [keep, drop, place, cost] = collapse;
    if (at(drop).empty() || at(keep).empty() || !stays_manifold(keep, drop)) return false;
    const Points points_before = mesh_.points;
    const Triangles triangles_before = mesh_.triangles;
    std::vector<int> gone, changed;
    mesh_.points.row(keep) = place.transpose();
    for (const int t : at(drop)) {
      if (has(t, keep)) {
        gone.push_back(t);
        continue;
      }
      changed.push_back(t);
      for (int i = 0; i < 3; ++i)
        if (mesh_.triangles(t, i) == drop) mesh_.triangles(t, i) = keep;
    }
    for (const int t : at(keep))
      if (std::find(gone.begin(), gone.end(), t) == gone.end()) changed.push_back(t);
    std::sort(changed.begin(), changed.end());
    for (const int t : gone) is_alive_[index(t)] = 0;
    for (const int t : changed) boxes_[index(t)] = box_of_triangle(mesh_, t);
    if (std::all_of(changed.begin(), changed.end(), [&](int t) { return is_sound(t); })) {
      for (const int t : gone)
        for (int i = 0; i < 3; ++i) std::erase(at(mesh_.triangles(t, i)), t);
      at(keep) = changed;
      at(drop).clear();
      return true;
    }
    mesh_.points = points_before;
    mesh_.triangles = triangles_before;
    for (const int t : gone) is_alive_[index(t)] = 1;
    for (const int t : changed) boxes_[index(t)] = box_of_triangle(mesh_, t);
    return false;
  }

  bool is_sound(int t) const {
    const Triangle3 corners = triangle_of(mesh_, t);
    if (is_degenerate(corners)) return false;
    for (int other = 0; other < static_cast<int>(boxes_.size()); ++other)
      if (other != t && is_alive_[index(other)] && boxes_[index(other)].intersects(boxes_[index(t)]) &&
          !is_degenerate(triangle_of(mesh_, other)) && triangles_of_mesh_meet(mesh_, t, other))
        return false;
    return !options_.is_allowed || options_.is_allowed(corners);
  }

  Simplified result() const {
    Simplified left;
    std::vector<int> row(at_.size(), -1);
    for (std::size_t v = 0; v < at_.size(); ++v)
      if (!at_[v].empty()) {
        row[v] = static_cast<int>(left.vertex_row.size());
        left.vertex_row.push_back(static_cast<int>(v));
      }
    for (std::size_t t = 0; t < is_alive_.size(); ++t)
      if (is_alive_[t]) left.triangle_row.push_back(static_cast<int>(t));
    left.mesh.points.resize(static_cast<Eigen::Index>(left.vertex_row.size()), 3);
    left.mesh.triangles.resize(static_cast<Eigen::Index>(left.triangle_row.size()), 3);
    for (std::size_t v = 0; v < left.vertex_row.size(); ++v)
      left.mesh.points.row(static_cast<Eigen::Index>(v)) = mesh_.points.row(left.vertex_row[v]);
    for (std::size_t t = 0; t < left.triangle_row.size(); ++t)
      for (int i = 0; i < 3; ++i)
        left.mesh.triangles(static_cast<Eigen::Index>(t), i) = row[index(mesh_.triangles(left.triangle_row[t], i))];
    return left;
  }

  IndexedMesh mesh_;
  const SimplifyOptions& options_;
  std::vector<char> is_alive_;
  std::vector<Box3> boxes_;
  std::vector<std::vector<int>> at_;  // triangles at each vertex
};

}  // namespace

Simplified simplify_hull(const IndexedMesh& mesh, const SimplifyOptions& options) {
  return Simplifying(mesh, options).run();
}

}  // namespace cagewright
