// SPDX-License-Identifier: BSD-3-Clause
#include "core/enclose/outside.h"

#include <algorithm>

#include "core/enclose/winding.h"
#include "core/parallel/parallel_for.h"

namespace cagewright {

VertexNeighbours::VertexNeighbours(const IndexedMesh& model)
    : first(static_cast<std::size_t>(model.points.rows()) + 1, 0),
      triangles(static_cast<std::size_t>(model.triangles.size())) {
  for (const int v : model.triangles.reshaped()) ++first[static_cast<std::size_t>(v) + 1];
  for (std::size_t v = 1; v < first.size(); ++v) first[v] += first[v - 1];
  std::vector<int> next(first.begin(), first.end() - 1);
  for (Eigen::Index k = 0; k < model.triangles.rows(); ++k)
    for (int i = 0; i < 3; ++i)
      triangles[static_cast<std::size_t>(next[static_cast<std::size_t>(model.triangles(k, i))]++)] =
          static_cast<int>(k);
}

Outside find_outside(const MovableCage& movable, const VertexNeighbours& neighbours, double gap, unsigned threads) {
  const IndexedMesh& model = movable.model();
  Outside result;
  result.vertices.assign(static_cast<std::size_t>(model.points.rows()), 0);
  result.meeting.resize(static_cast<std::size_t>(movable.triangle_count()));
  parallel_for(result.meeting.size(), threads, [&](std::size_t t) {
    movable.visit_hits(static_cast<int>(t), MovableCage::Whose::any, gap, [&](int k) {
      result.meeting[t].push_back(k);
      return false;
    });
    std::sort(result.meeting[t].begin(), result.meeting[t].end());
  });
  std::vector<char> meets(static_cast<std::size_t>(model.triangles.rows()), 0);
  std::vector<int> asked;
  for (const std::vector<int>& of_triangle : result.meeting)
    for (const int k : of_triangle) {
      meets[static_cast<std::size_t>(k)] = 1;
      for (int i = 0; i < 3; ++i) asked.push_back(model.triangles(k, i));
    }
  std::sort(asked.begin(), asked.end());
  asked.erase(std::unique(asked.begin(), asked.end()), asked.end());
  result.none = asked.empty();
  if (result.none) return result;
  const BoxTree tree(movable.mesh());
  const Winding winding(movable.mesh(), tree);
  std::vector<char> is_out(asked.size(), 0);
  parallel_for(asked.size(), threads, [&](std::size_t i) {
    const auto number = winding.of(model.points.row(asked[i]));
    is_out[i] = !number || *number <= 0;
  });
  std::vector<int> to_visit;
  for (std::size_t i = 0; i < asked.size(); ++i)
    if (is_out[i]) {
      result.vertices[static_cast<std::size_t>(asked[i])] = 1;
      to_visit.push_back(asked[i]);
    }
  while (!to_visit.empty()) {
    const auto v = static_cast<std::size_t>(to_visit.back());
    to_visit.pop_back();
    for (int at = neighbours.first[v]; at < neighbours.first[v + 1]; ++at) {
      const int k = neighbours.triangles[static_cast<std::size_t>(at)];
      if (meets[static_cast<std::size_t>(k)]) continue;
      for (int i = 0; i < 3; ++i) {
        char& other = result.vertices[static_cast<std::size_t>(model.triangles(k, i))];
        if (other) continue;
        other = 1;
        to_visit.push_back(model.triangles(k, i));
      }
    }
  }
  return result;
}

}  // namespace cagewright
