// SPDX-License-Identifier: BSD-3-Clause
#include "core/mesh/connectivity.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "core/mesh/weld.h"
#include "core/mesh/welded_edges.h"

namespace cagewright {
namespace {

// Union-find in which the least member stands for its set, so that labels do not depend on the order of unions.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }

  int find(int item) {
    while (parent_[item] != item) item = parent_[item] = parent_[parent_[item]];
    return item;
  }

  void unite(int a, int b) {
    a = find(a);
    b = find(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

  Labels labels() && {
    Labels labels{std::move(parent_), 0};
    // A parent is never greater than its child, so it already holds its label.
    for (std::size_t i = 0; i < labels.of.size(); ++i) {
      int& entry = labels.of[i];
      entry = entry == static_cast<int>(i) ? labels.count++ : labels.of[entry];
    }
    return labels;
  }

 private:
  std::vector<int> parent_;
};

}  // namespace

EdgeTable find_edges(const Triangles& triangles, Eigen::Index vertices) {
  const int count = static_cast<int>(triangles.size());
  const auto lower = [&](int h) { return std::min(from_vertex(triangles, h), to_vertex(triangles, h)); };
  const auto upper = [&](int h) { return std::max(from_vertex(triangles, h), to_vertex(triangles, h)); };

  // Counting sort by the lower vertex; then only the few edges of one vertex remain to be sorted.
  std::vector<int> begin(static_cast<std::size_t>(vertices) + 1, 0);
  for (int h = 0; h < count; ++h) ++begin[lower(h) + 1];
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<std::pair<int, int>> sorted(count);  // upper vertex, half-edge
  std::vector<int> end(begin.begin(), begin.end() - 1);
  for (int h = 0; h < count; ++h) sorted[end[lower(h)]++] = {upper(h), h};

  EdgeTable edges;
  edges.half_edges.resize(count);
  edges.first.reserve(static_cast<std::size_t>(count) / 2 + 2);
  for (Eigen::Index v = 0; v < vertices; ++v) {
    std::sort(sorted.begin() + begin[v], sorted.begin() + begin[v + 1]);
    for (int i = begin[v]; i < begin[v + 1]; ++i) {
      if (i == begin[v] || sorted[i].first != sorted[i - 1].first) edges.first.push_back(i);
      edges.half_edges[i] = sorted[i].second;
    }
  }
  edges.first.push_back(count);
  return edges;
}

std::vector<int> find_opposites(const EdgeTable& edges) {
  std::vector<int> opposite(edges.half_edges.size(), -1);
  for (int e = 0; e < edges.count(); ++e) {
    const auto pair = edges.of(e);
    if (pair.size() != 2) continue;
    opposite[pair[0]] = pair[1];
    opposite[pair[1]] = pair[0];
  }
  return opposite;
}

Labels find_components(const Triangles& triangles, const EdgeTable& edges) {
  DisjointSets sets(static_cast<std::size_t>(triangles.rows()));
  for (int e = 0; e < edges.count(); ++e) {
    const auto group = edges.of(e);
    for (const int h : group.subspan(1)) sets.unite(group.front() / 3, h / 3);
  }
  return std::move(sets).labels();
}

Labels find_fans(const Triangles& triangles, const EdgeTable& edges) {
  DisjointSets sets(static_cast<std::size_t>(triangles.size()));
  for (int e = 0; e < edges.count(); ++e) {
    const auto group = edges.of(e);
    const int h = group.front();
    for (const int g : group.subspan(1)) {
      const bool same_direction = from_vertex(triangles, g) == from_vertex(triangles, h);
      sets.unite(h, same_direction ? g : next_in_triangle(g));
      sets.unite(next_in_triangle(h), same_direction ? next_in_triangle(g) : g);
    }
  }
  return std::move(sets).labels();
}

Connectivity connect(const IndexedMesh& mesh) {
  EdgeTable edges = find_edges(mesh.triangles, mesh.points.rows());
  Labels components = find_components(mesh.triangles, edges);
  Labels fans = find_fans(mesh.triangles, edges);
  return {std::move(edges), std::move(components), std::move(fans)};
}

Connectivity connect(const WeldedMesh& welded) {
  const Triangles& triangles = welded.mesh.triangles;
  EdgeTable edges = find_edges(triangles, welded.mesh.points.rows());
  Labels fans;
  if (auto separated = separate_welded_edges(triangles, welded.given, edges)) {
    edges = std::move(separated->edges);
    fans = std::move(separated->fans);
  } else {
    fans = find_fans(triangles, edges);
  }
  Labels components = find_components(triangles, edges);
  return {std::move(edges), std::move(components), std::move(fans)};
}

}  // namespace cagewright
