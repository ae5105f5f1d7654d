// SPDX-License-Identifier: BSD-3-Clause
#include "core/mesh/weld.h"

#include <array>
#include <bit>
#include <limits>
#include <string>
#include <vector>

#include "core/error/error.h"

namespace cagewright {
namespace {

// Half-edges are counted by int, here and in OpenMesh.
constexpr Eigen::Index most_triangles = std::numeric_limits<int>::max() / 3;

ErrorPlace at_element(Eigen::Index element) {
  ErrorPlace place;
  place.element = static_cast<std::size_t>(element);
  return place;
}

void require_mesh(const IndexedMesh& mesh) {
  const auto& [points, triangles] = mesh;
  if (triangles.rows() == 0) {
    throw Error(ErrorCode::mesh_empty, "the model has no triangle: choose a mesh that has faces");
  }
  if (triangles.rows() > most_triangles) {
    throw Error(ErrorCode::mesh_index, "the model has " + std::to_string(triangles.rows()) + " triangles, more than " +
                                           std::to_string(most_triangles) + ": simplify it");
  }
  for (Eigen::Index v = 0; v < points.rows(); ++v) {
    if (!points.row(v).allFinite()) {
      throw Error(ErrorCode::mesh_not_finite,
                  "vertex " + std::to_string(v) + " of the model is at " + to_text(points.row(v).transpose()) +
                      ", which is no finite position: repair or remove it",
                  at_element(v));
    }
  }
  for (Eigen::Index t = 0; t < triangles.rows(); ++t) {
    for (const int v : triangles.row(t)) {
      if (v < 0 || v >= points.rows()) {
        throw Error(ErrorCode::mesh_index,
                    "triangle " + std::to_string(t) + " of the model names vertex " + std::to_string(v) +
                        ", but the model has " + std::to_string(points.rows()) +
                        " vertices, counted from 0: repair its indices",
                    at_element(t));
      }
    }
  }
}

using Key = std::array<std::uint64_t, 3>;

Key key_of(const Points& points, Eigen::Index v) {
  Key key;
  for (int k = 0; k < 3; ++k) key[k] = std::bit_cast<std::uint64_t>(points(v, k) + 0.0);  // -0 + 0 is 0
  return key;
}

std::uint64_t hash_of(const Key& key) {
  std::uint64_t hash = 0;
  for (const std::uint64_t word : key) {
    hash = (hash ^ word) * 0x9E3779B97F4A7C15u;
    hash ^= hash >> 29;
  }
  hash *= 0xBF58476D1CE4E5B9u;
  return hash ^ (hash >> 32);
}

// For each vertex the first one at its position. Open addressing, so that a million points need one allocation.
std::vector<int> first_at_position(const Points& points) {
  const std::size_t count = static_cast<std::size_t>(points.rows());
  const std::size_t mask = std::bit_ceil(2 * count + 1) - 1;
  std::vector<int> slots(mask + 1, -1);
  std::vector<int> first(count);
  for (std::size_t v = 0; v < count; ++v) {
    const Key key = key_of(points, static_cast<Eigen::Index>(v));
    std::size_t slot = hash_of(key) & mask;
    while (slots[slot] >= 0 && key_of(points, slots[slot]) != key) slot = (slot + 1) & mask;
    if (slots[slot] < 0) slots[slot] = static_cast<int>(v);
    first[v] = slots[slot];
  }
  return first;
}

}  // namespace

WeldedMesh weld(const IndexedMesh& mesh) {
  require_mesh(mesh);
  const std::vector<int> first = first_at_position(mesh.points);
  WeldedMesh welded;
  for (std::size_t v = 0; v < first.size(); ++v) welded.welded_vertices += first[v] != static_cast<int>(v);

  std::vector<int> row_of(first.size(), -1);
  Triangles& triangles = welded.mesh.triangles;
  triangles.resize(mesh.triangles.rows(), 3);
  welded.given.resize(mesh.triangles.rows(), 3);
  Eigen::Index kept = 0;
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    const int a = first[mesh.triangles(t, 0)], b = first[mesh.triangles(t, 1)], c = first[mesh.triangles(t, 2)];
    if (a == b || b == c || c == a) {
      ++welded.degenerate_triangles;
      continue;
    }
    welded.given.row(kept) = mesh.triangles.row(t);
    welded.given_rows.push_back(static_cast<int>(t));
    triangles.row(kept++) << a, b, c;
    row_of[a] = row_of[b] = row_of[c] = 0;
  }
  if (kept == 0) {
    throw Error(ErrorCode::mesh_empty, "all " + std::to_string(mesh.triangles.rows()) +
                                           " triangles of the model have two corners at the same position: choose a "
                                           "mesh that has an area");
  }
  triangles.conservativeResize(kept, 3);
  welded.given.conservativeResize(kept, 3);

  int used = 0;
  for (int& row : row_of) row = row < 0 ? -1 : used++;
  welded.unused_vertices = first.size() - welded.welded_vertices - static_cast<std::size_t>(used);
  welded.mesh.points.resize(used, 3);
  for (std::size_t v = 0; v < row_of.size(); ++v) {
    if (row_of[v] >= 0) welded.mesh.points.row(row_of[v]) = mesh.points.row(static_cast<Eigen::Index>(v));
  }
  for (int* corner = triangles.data(); corner != triangles.data() + triangles.size(); ++corner) {
    *corner = row_of[*corner];
  }
  return welded;
}

std::vector<int> find_given_vertices(const WeldedMesh& welded) {
  std::vector<int> given(static_cast<std::size_t>(welded.mesh.points.rows()), -1);
  for (Eigen::Index k = welded.given.size() - 1; k >= 0; --k)
    given[static_cast<std::size_t>(welded.mesh.triangles.data()[k])] = welded.given.data()[k];
  return given;
}

}  // namespace cagewright
