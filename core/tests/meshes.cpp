// SPDX-License-Identifier: BSD-3-Clause
#include "core/tests/meshes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace cagewright::meshes {
namespace {

constexpr double pi = std::numbers::pi;

IndexedMesh to_mesh(const std::vector<Vector3>& points, const std::vector<std::array<int, 3>>& triangles) {
  IndexedMesh mesh;
  mesh.points.resize(static_cast<Eigen::Index>(points.size()), 3);
  mesh.triangles.resize(static_cast<Eigen::Index>(triangles.size()), 3);
  for (std::size_t v = 0; v < points.size(); ++v) mesh.points.row(static_cast<Eigen::Index>(v)) = points[v].transpose();
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    mesh.triangles.row(static_cast<Eigen::Index>(t)) << triangles[t][0], triangles[t][1], triangles[t][2];
  }
  return mesh;
}

// Two triangles for each cell of a grid of `around` by `across` cells; `row_of` closes it up as it likes.
template <class RowOf>
std::vector<std::array<int, 3>> grid(int around, int across, RowOf row_of) {
  std::vector<std::array<int, 3>> triangles;
  for (int i = 0; i < around; ++i) {
    for (int j = 0; j < across; ++j) {
      const int a = row_of(i, j), b = row_of(i + 1, j), c = row_of(i + 1, j + 1), d = row_of(i, j + 1);
      triangles.push_back({a, b, c});
      triangles.push_back({a, c, d});
    }
  }
  return triangles;
}

}  // namespace

IndexedMesh surface_of_cells(const std::set<std::array<int, 3>>& cells) {
  std::map<std::array<int, 3>, int> row_of;
  std::vector<Vector3> points;
  std::vector<std::array<int, 3>> triangles;
  const auto vertex = [&](const std::array<int, 3>& at) {
    const auto [entry, is_new] = row_of.try_emplace(at, static_cast<int>(points.size()));
    if (is_new) points.emplace_back(at[0], at[1], at[2]);
    return entry->second;
  };
  for (const auto& cell : cells) {
    for (int axis = 0; axis < 3; ++axis) {
      for (int side = 0; side < 2; ++side) {
        auto neighbour = cell;
        neighbour[axis] += 2 * side - 1;
        if (cells.contains(neighbour)) continue;
        std::array<int, 4> quad;
        for (int i = 0; i < 4; ++i) {
          auto corner = cell;
          corner[axis] += side;
          corner[(axis + 1) % 3] += i == 1 || i == 2;
          corner[(axis + 2) % 3] += i >= 2;
          quad[side == 1 ? i : 3 - i] = vertex(corner);
        }
        triangles.push_back({quad[0], quad[1], quad[2]});
        triangles.push_back({quad[0], quad[2], quad[3]});
      }
    }
  }
  return to_mesh(points, triangles);
}

IndexedMesh tetrahedron() {
  return to_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}});
}

IndexedMesh box(const Vector3& min, const Vector3& max) {
  IndexedMesh mesh = surface_of_cells({{0, 0, 0}});
  for (Eigen::Index v = 0; v < mesh.points.rows(); ++v) {
    for (int k = 0; k < 3; ++k) mesh.points(v, k) = mesh.points(v, k) == 0 ? min[k] : max[k];
  }
  return mesh;
}

IndexedMesh icosphere(int subdivisions) {
  const double golden = std::numbers::phi;
  std::vector<Vector3> points = {{-1, golden, 0}, {1, golden, 0}, {-1, -golden, 0}, {1, -golden, 0},
                                 {0, -1, golden}, {0, 1, golden}, {0, -1, -golden}, {0, 1, -golden},
                                 {golden, 0, -1}, {golden, 0, 1}, {-golden, 0, -1}, {-golden, 0, 1}};
  for (Vector3& point : points) point.normalize();
  std::vector<std::array<int, 3>> triangles = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                                               {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                                               {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                                               {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
  for (int round = 0; round < subdivisions; ++round) {
    std::map<std::pair<int, int>, int> middle_of;
    const auto middle = [&](int a, int b) {
      const auto [entry, is_new] = middle_of.try_emplace(std::minmax(a, b), static_cast<int>(points.size()));
      if (is_new) points.push_back((points[a] + points[b]).normalized());
      return entry->second;
    };
    std::vector<std::array<int, 3>> finer;
    for (const auto& [a, b, c] : triangles) {
      const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
    }
    triangles = std::move(finer);
  }
  return to_mesh(points, triangles);
}

IndexedMesh capsule(double radius, double length, int around, int up) {
  std::vector<Vector3> points;
  std::vector<std::array<int, 3>> triangles;
  // Rings from the south to the north; `up` rings on each half sphere, the poles apart.
  for (int half = 0; half < 2; ++half) {
    for (int j = 0; j < up; ++j) {
      const double latitude = 0.5 * pi * (half == 0 ? double(j + 1) / up - 1 : double(j) / up);
      for (int i = 0; i < around; ++i) {
        const double angle = 2 * pi * i / around;
        points.emplace_back(radius * std::cos(latitude) * std::cos(angle),
                            radius * std::cos(latitude) * std::sin(angle),
                            radius * std::sin(latitude) + (half == 0 ? -0.5 : 0.5) * length);
      }
    }
  }
  const int rings = 2 * up;
  triangles = grid(around, rings - 1, [&](int i, int j) { return j * around + i % around; });
  const int south = static_cast<int>(points.size()), north = south + 1;
  points.emplace_back(0, 0, -radius - 0.5 * length);
  points.emplace_back(0, 0, radius + 0.5 * length);
  for (int i = 0; i < around; ++i) {
    const int next = (i + 1) % around, last = (rings - 1) * around;
    triangles.push_back({south, next, i});
    triangles.push_back({north, last + i, last + next});
  }
  return to_mesh(points, triangles);
}

IndexedMesh torus(double major, double minor, int around, int across) {
  std::vector<Vector3> points;
  for (int i = 0; i < around; ++i) {
    for (int j = 0; j < across; ++j) {
      const double u = 2 * pi * i / around, v = 2 * pi * j / across;
      const double r = major + minor * std::cos(v);
      points.emplace_back(r * std::cos(u), r * std::sin(u), minor * std::sin(v));
    }
  }
  return to_mesh(points, grid(around, across, [&](int i, int j) { return i % around * across + j % across; }));
}

IndexedMesh perforated_plate(int holes) {
  std::set<std::array<int, 3>> cells;
  for (int x = 0; x < 2 * holes + 1; ++x) {
    for (int y = 0; y < 3; ++y) {
      if (x % 2 == 0 || y != 1) cells.insert({x, y, 0});
    }
  }
  return surface_of_cells(cells);
}

IndexedMesh bow_tie() {
  return to_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}},
                 {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}, {0, 4, 5}, {0, 6, 4}, {0, 5, 6}, {4, 6, 5}});
}

IndexedMesh bow_tie_edge() { return surface_of_cells({{0, 0, 0}, {1, 1, 0}}); }

IndexedMesh touching_boxes() { return together(box({0, 0, 0}, {1, 1, 1}), box({1, 1, 0}, {2, 2, 1})); }

IndexedMesh pinched_ring() {
  return surface_of_cells({{0, 0, 0},
                           {0, -1, 0},
                           {1, -1, 0},
                           {2, -1, 0},
                           {3, -1, 0},
                           {3, 0, 0},
                           {3, 1, 0},
                           {3, 1, 1},
                           {2, 1, 1},
                           {1, 1, 1}});
}

IndexedMesh seamed_pinch() {
  IndexedMesh mesh =
      surface_of_cells({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 1}, {1, 1, 1}, {0, 0, 2}, {1, 0, 2}, {1, 1, 2}});
  for (const double z : {1.0, 2.0}) {
    const int copy = static_cast<int>(mesh.points.rows());
    mesh.points.conservativeResize(copy + 1, 3);
    mesh.points.row(copy) << 1, 1, z;
    for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
      double sum = 0;  // beyond the diagonal x + y = 2 the edge's ends are the copies
      for (const int v : mesh.triangles.row(t)) sum += mesh.points(v, 0) + mesh.points(v, 1) - 2;
      for (int& v : mesh.triangles.row(t)) {
        if (sum > 0 && mesh.points.row(v) == mesh.points.row(copy)) v = copy;
      }
    }
  }
  return mesh;
}

IndexedMesh hollow_sphere(int subdivisions) {
  const IndexedMesh sphere = icosphere(subdivisions);
  return together(sphere, moved(inside_out(sphere), 0.5, Vector3::Zero()));
}

IndexedMesh klein_bottle(int around, int across) {
  std::vector<Vector3> points;
  for (int i = 0; i < around; ++i) {
    for (int j = 0; j < across; ++j) {
      const double u = 2 * pi * i / around, v = 2 * pi * j / across;
      const double x = std::sin(v), y = std::sin(2 * v);  // an eight, turned by half while it goes round
      const double r = 3 + std::cos(u / 2) * x - std::sin(u / 2) * y;
      points.emplace_back(r * std::cos(u), r * std::sin(u), std::sin(u / 2) * x + std::cos(u / 2) * y);
    }
  }
  return to_mesh(points, grid(around, across, [&](int i, int j) {
                   // Half a turn maps v to -v: x and y change their signs.
                   return i < around ? i * across + j % across : (across - j % across) % across;
                 }));
}

IndexedMesh moebius_band(int around) {
  std::vector<Vector3> points;
  for (int i = 0; i < around; ++i) {
    for (const double width : {-0.5, 0.5}) {
      const double u = 2 * pi * i / around;
      const double r = 2 + width * std::cos(u / 2);
      points.emplace_back(r * std::cos(u), r * std::sin(u), width * std::sin(u / 2));
    }
  }
  return to_mesh(points, grid(around, 1, [&](int i, int j) { return i < around ? 2 * i + j : 1 - j; }));
}

IndexedMesh without_triangle(const IndexedMesh& mesh, Eigen::Index triangle) {
  IndexedMesh result{mesh.points, Triangles(mesh.triangles.rows() - 1, 3)};
  result.triangles << mesh.triangles.topRows(triangle), mesh.triangles.bottomRows(mesh.triangles.rows() - triangle - 1);
  return result;
}

IndexedMesh inside_out(const IndexedMesh& mesh) {
  IndexedMesh result = mesh;
  result.triangles.col(1).swap(result.triangles.col(2));
  return result;
}

IndexedMesh randomly_turned(const IndexedMesh& mesh, unsigned seed) {
  IndexedMesh result = mesh;
  std::mt19937 random(seed);
  for (Eigen::Index t = 0; t < result.triangles.rows(); ++t) {
    if (random() % 2 == 1) std::swap(result.triangles(t, 0), result.triangles(t, 1));
  }
  return result;
}

IndexedMesh shuffled(const IndexedMesh& mesh, unsigned seed) {
  std::mt19937 random(seed);
  const auto permutation = [&](Eigen::Index count) {
    std::vector<int> order(static_cast<std::size_t>(count));
    std::iota(order.begin(), order.end(), 0);
    for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random() % i]);
    return order;
  };
  const std::vector<int> vertex = permutation(mesh.points.rows()), triangle = permutation(mesh.triangles.rows());
  IndexedMesh result = mesh;
  for (Eigen::Index v = 0; v < mesh.points.rows(); ++v) result.points.row(vertex[v]) = mesh.points.row(v);
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    for (int i = 0; i < 3; ++i) result.triangles(triangle[t], i) = vertex[mesh.triangles(t, i)];
  }
  return result;
}

IndexedMesh with_own_vertices(const IndexedMesh& mesh) {
  IndexedMesh result{Points(mesh.triangles.size(), 3), Triangles(mesh.triangles.rows(), 3)};
  for (Eigen::Index corner = 0; corner < mesh.triangles.size(); ++corner) {
    result.points.row(corner) = mesh.points.row(mesh.triangles.data()[corner]);
    result.triangles.data()[corner] = static_cast<int>(corner);
  }
  return result;
}

IndexedMesh together(const IndexedMesh& first, const IndexedMesh& second) {
  IndexedMesh result{Points(first.points.rows() + second.points.rows(), 3),
                     Triangles(first.triangles.rows() + second.triangles.rows(), 3)};
  result.points << first.points, second.points;
  result.triangles << first.triangles, (second.triangles.array() + static_cast<int>(first.points.rows())).matrix();
  return result;
}

IndexedMesh moved(const IndexedMesh& mesh, double scale, const Vector3& offset) {
  IndexedMesh result = mesh;
  result.points = (scale * mesh.points).rowwise() + offset.transpose();
  return result;
}

}  // namespace cagewright::meshes
