// SPDX-License-Identifier: BSD-3-Clause
#include "core/mesh/orientation.h"

#include <algorithm>
#include <utility>

#include "core/mesh/nesting.h"

namespace cagewright {
namespace {

bool same_direction(const Triangles& triangles, int half_edge, int other) {
  return from_vertex(triangles, half_edge) == from_vertex(triangles, other);
}

// Turns the triangles that disagree with the first one of their component.
std::vector<bool> flood(const Triangles& triangles, const EdgeTable& edges) {
  const std::vector<int> opposite = find_opposites(edges);
  const int count = static_cast<int>(triangles.rows());
  std::vector<bool> turned(count, false), seen(count, false);
  std::vector<int> front;
  for (int seed = 0; seed < count; ++seed) {
    if (seen[seed]) continue;
    seen[seed] = true;
    front.push_back(seed);
    while (!front.empty()) {
      const int t = front.back();
      front.pop_back();
      for (int h = 3 * t; h < 3 * t + 3; ++h) {
        const int other = opposite[h] / 3;
        if (opposite[h] < 0 || seen[other]) continue;
        seen[other] = true;
        turned[other] = turned[t] != same_direction(triangles, h, opposite[h]);
        front.push_back(other);
      }
    }
  }
  return turned;
}

}  // namespace

Turns find_consistent_turns(const Triangles& triangles, const Connectivity& connectivity) {
  const auto& [edges, components, fans] = connectivity;
  Turns turns{flood(triangles, edges), std::nullopt};
  for (int e = 0; e < edges.count() && !turns.conflicting_edge; ++e) {
    const auto pair = edges.of(e);
    if (pair.size() != 2) continue;
    const bool differ = turns.turned[pair[0] / 3] != turns.turned[pair[1] / 3];
    if (differ != same_direction(triangles, pair[0], pair[1])) turns.conflicting_edge = e;
  }

  std::vector<int> balance(static_cast<std::size_t>(components.count), 0);
  for (std::size_t t = 0; t < turns.turned.size(); ++t) balance[components.of[t]] += turns.turned[t] ? 1 : -1;
  for (std::size_t t = 0; t < turns.turned.size(); ++t) {
    if (balance[components.of[t]] > 0) turns.turned[t] = !turns.turned[t];
  }
  return turns;
}

void turn(Triangles& triangles, Eigen::Index t) { std::swap(triangles(t, 1), triangles(t, 2)); }

std::vector<bool> find_inside_out(const IndexedMesh& mesh, const Labels& components, const Volumes& volumes) {
  std::vector<bool> inside_out(volumes.of.size(), false);
  if (std::ranges::none_of(volumes.of, [](double volume) { return volume < 0; })) return inside_out;
  const std::vector<int> outermost = find_outermost(mesh, components, volumes);
  for (std::size_t k = 0; k < inside_out.size(); ++k) inside_out[k] = volumes.of[outermost[k]] < 0;
  return inside_out;
}

}  // namespace cagewright
