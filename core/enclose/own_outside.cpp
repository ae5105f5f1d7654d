// SPDX-License-Identifier: BSD-3-Clause
#include "core/enclose/own_outside.h"

#include <algorithm>
#include <map>
#include <memory>

#include "core/enclose/winding.h"
#include "core/parallel/parallel_for.h"

namespace cagewright {
namespace {

using Whose = MovableCage::Whose;

// The walls of some parts, closed by the sections between them and all others.
struct Shell {
  IndexedMesh mesh;
  std::unique_ptr<BoxTree> tree;
  std::unique_ptr<Winding> winding;

  Shell(const MovableCage& movable, const std::vector<int>& parts) {
    std::vector<std::array<int, 3>> triangles;
    const auto is_one = [&](int part) { return std::binary_search(parts.begin(), parts.end(), part); };
    for (int t = 0; t < movable.triangle_count(); ++t)
      if (is_one(movable.cage().triangle_part[static_cast<std::size_t>(t)]))
        triangles.push_back({movable.vertex_of(t, 0), movable.vertex_of(t, 1), movable.vertex_of(t, 2)});
    const auto& slide_parts = movable.segmentation().slide_parts;
    for (std::size_t k = 0; k < slide_parts.size(); ++k) {
      const bool behind = is_one(slide_parts[k][0]), ahead = is_one(slide_parts[k][1]);
      if (behind == ahead) continue;
      const std::array<int, 4> c = movable.cage().corners_of(static_cast<int>(k));  // round the slide's normal
      const auto add = [&](int i, int j, int l) {
        triangles.push_back(behind ? std::array<int, 3>{i, j, l} : std::array<int, 3>{i, l, j});
      };
      add(c[0], c[1], c[2]);
      add(c[0], c[2], c[3]);
    }
    mesh.points = movable.points();
    mesh.triangles.resize(static_cast<Eigen::Index>(triangles.size()), 3);
    for (std::size_t t = 0; t < triangles.size(); ++t)
      mesh.triangles.row(static_cast<Eigen::Index>(t)) << triangles[t][0], triangles[t][1], triangles[t][2];
    if (triangles.empty()) return;
    tree = std::make_unique<BoxTree>(mesh);
    winding = std::make_unique<Winding>(mesh, *tree);
  }
  bool contains(const Vector3& p) const {
    if (!winding) return false;
    const auto number = winding->of(p);
    return number && *number > 0;
  }
};

void find_meeting(const MovableCage& movable, double gap, unsigned threads, Outside& result) {
  result.meeting.resize(static_cast<std::size_t>(movable.triangle_count()));
  parallel_for(result.meeting.size(), threads, [&](std::size_t t) {
    movable.visit_hits(static_cast<int>(t), Whose::own, gap, [&](int k) {
      if (movable.is_of_part(static_cast<int>(t), k)) result.meeting[t].push_back(k);
      return false;
    });
    std::sort(result.meeting[t].begin(), result.meeting[t].end());
  });
}

void spread_outside(const MovableCage& movable, const VertexNeighbours& neighbours, const std::vector<char>& meets,
                    std::vector<int> open, Outside& result) {
  const Triangles& triangles = movable.model().triangles;
  while (!open.empty()) {
    const auto v = static_cast<std::size_t>(open.back());
    open.pop_back();
    for (int at = neighbours.first[v]; at < neighbours.first[v + 1]; ++at) {
      const int k = neighbours.triangles[static_cast<std::size_t>(at)];
      if (meets[static_cast<std::size_t>(k)]) continue;
      for (int i = 0; i < 3; ++i) {
        char& other = result.vertices[static_cast<std::size_t>(triangles(k, i))];
        if (other) continue;
        other = 1;
        open.push_back(triangles(k, i));
      }
    }
  }
}

}  // namespace

std::vector<int> find_own_parts(const MovableCage& movable, const VertexNeighbours& neighbours, int vertex) {
  const auto v = static_cast<std::size_t>(vertex);
  std::vector<int> parts;
  for (int at = neighbours.first[v]; at < neighbours.first[v + 1]; ++at) {
    const int k = neighbours.triangles[static_cast<std::size_t>(at)];
    parts.push_back(movable.segmentation().triangle_part[static_cast<std::size_t>(k)]);
    const auto beyond = movable.parts_beyond(k);
    parts.insert(parts.end(), beyond.begin(), beyond.end());
  }
  std::sort(parts.begin(), parts.end());
  parts.erase(std::unique(parts.begin(), parts.end()), parts.end());
  return parts;
}

Outside find_own_outside(const MovableCage& movable, const VertexNeighbours& neighbours, double gap, unsigned threads) {
  const IndexedMesh& model = movable.model();
  Outside result;
  result.vertices.assign(static_cast<std::size_t>(model.points.rows()), 0);
  find_meeting(movable, gap, threads, result);
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
  std::map<std::vector<int>, std::unique_ptr<Shell>> shells;
  std::vector<const Shell*> shell_of;
  for (const int v : asked) {
    const std::vector<int> parts = find_own_parts(movable, neighbours, v);
    auto& shell = shells[parts];
    if (!shell) shell = std::make_unique<Shell>(movable, parts);
    shell_of.push_back(shell.get());
  }
  std::vector<char> is_out(asked.size(), 0);
  parallel_for(asked.size(), threads,
               [&](std::size_t i) { is_out[i] = !shell_of[i]->contains(model.points.row(asked[i])); });
  std::vector<int> open;
  for (std::size_t i = 0; i < asked.size(); ++i)
    if (is_out[i]) {
      result.vertices[static_cast<std::size_t>(asked[i])] = 1;
      open.push_back(asked[i]);
    }
  spread_outside(movable, neighbours, meets, std::move(open), result);
  return result;
}

}  // namespace cagewright
