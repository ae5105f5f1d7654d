// SPDX-License-Identifier: BSD-3-Clause
#include "core/mesh/welded_edges.h"

#include <algorithm>
#include <utility>

namespace cagewright {
namespace {

using Pair = std::pair<int, int>;

Pair sorted_pair(int a, int b) { return {std::min(a, b), std::max(a, b)}; }

// Whether two triangles at an edge have the same third corner: then they coincide and have no place side by side.
bool have_coinciding_triangles(const Triangles& triangles, std::span<const int> group) {
  std::vector<int> third;
  for (const int h : group) third.push_back(to_vertex(triangles, next_in_triangle(h)));
  std::ranges::sort(third);
  return std::ranges::adjacent_find(third) != third.end();
}

// The half-edges of one edge in the order in which they pair up; empty where they do not.
std::vector<int> pair_up(const Triangles& triangles, const Triangles& given, std::span<const int> group) {
  if (group.size() <= 2 || have_coinciding_triangles(triangles, group)) return {};
  std::vector<std::pair<Pair, int>> keyed;
  for (const int h : group) keyed.push_back({sorted_pair(from_vertex(given, h), to_vertex(given, h)), h});
  std::ranges::sort(keyed);
  std::vector<int> paired, left;
  for (std::size_t i = 0; i < keyed.size();) {
    const std::size_t begin = i;
    while (i < keyed.size() && keyed[i].first == keyed[begin].first) ++i;
    std::vector<int>& where = i - begin == 2 ? paired : left;
    for (std::size_t k = begin; k < i; ++k) where.push_back(keyed[k].second);
  }
  if (left.size() != 0 && left.size() != 2) return {};
  paired.insert(paired.end(), left.begin(), left.end());
  return paired;
}

// The fans at both ends of an edge: the vertices it will have once bow-ties are split.
Pair ends_of(const EdgeTable& edges, const Labels& fans, int edge) {
  const int h = edges.of(edge).front();
  return sorted_pair(fans.of[h], fans.of[next_in_triangle(h)]);
}

}  // namespace

std::optional<SeparatedEdges> separate_welded_edges(const Triangles& triangles, const Triangles& given,
                                                    const EdgeTable& edges) {
  SeparatedEdges result;
  std::vector<int> made;  // new edges
  result.edges.half_edges = edges.half_edges;
  for (int e = 0; e < edges.count(); ++e) {
    const auto group = edges.of(e);
    const std::vector<int> paired = pair_up(triangles, given, group);
    if (paired.empty()) {
      result.edges.first.push_back(edges.first[e]);
      continue;
    }
    std::ranges::copy(paired, result.edges.half_edges.begin() + edges.first[e]);
    for (int i = edges.first[e]; i < edges.first[e + 1]; i += 2) {
      made.push_back(static_cast<int>(result.edges.first.size()));
      result.edges.first.push_back(i);
    }
  }
  if (made.empty()) return std::nullopt;
  result.edges.first.push_back(edges.first.back());

  result.fans = find_fans(triangles, result.edges);
  std::vector<Pair> ends;
  for (const int e : made) ends.push_back(ends_of(result.edges, result.fans, e));
  std::ranges::sort(ends);
  if (std::ranges::adjacent_find(ends) != ends.end()) return std::nullopt;
  return result;
}

}  // namespace cagewright
