// SPDX-License-Identifier: BSD-3-Clause
// Triangles are sorted along a Morton curve and every four in a row get a box, every four boxes another (Lauterbach et
// al., Fast BVH Construction on GPUs, 2009, without the splits). Made and searched three times as fast as
// Eigen's KdBVH with BVMinimize: see docs/algorithms/measures.md.
#include "core/enclose/surface_tree.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/enclose/triangle_distance.h"
#include "core/mesh/morton.h"
#include "core/parallel/parallel_for.h"

namespace cagewright {
namespace {

constexpr std::size_t fan = 4;
constexpr std::size_t block_size = 1 << 14;

struct Keyed {
  std::uint64_t code;
  int triangle;
  bool operator<(const Keyed& other) const {
    return code != other.code ? code < other.code : triangle < other.triangle;
  }
};

// Calls body(first, last) for the blocks of 0 to count.
template <class Body>
void for_blocks(std::size_t count, unsigned threads, const Body& body) {
  parallel_for((count + block_size - 1) / block_size, threads,
               [&](std::size_t b) { body(b * block_size, std::min(count, (b + 1) * block_size)); });
}

// A total order, so that the result does not depend on how the sort is cut into pieces.
void sort(std::vector<Keyed>& keys, unsigned threads) {
  const std::size_t half = keys.size() / 2;
  const auto at = [&](std::size_t i) { return keys.begin() + static_cast<std::ptrdiff_t>(i); };
  parallel_for(2, threads, [&](std::size_t i) { std::sort(at(i * half), i == 0 ? at(half) : keys.end()); });
  std::inplace_merge(keys.begin(), at(half), keys.end());
}

std::vector<Keyed> along_curve(const IndexedMesh& mesh, unsigned threads) {
  const Vector3 min = mesh.points.colwise().minCoeff(), max = mesh.points.colwise().maxCoeff();
  const double side = std::max((max - min).maxCoeff(), std::numeric_limits<double>::min());
  std::vector<Keyed> keys(static_cast<std::size_t>(mesh.triangles.rows()));
  for_blocks(keys.size(), threads, [&](std::size_t first, std::size_t last) {
    for (std::size_t t = first; t < last; ++t) {
      const Triangle3 corners = triangle_of(mesh, static_cast<Eigen::Index>(t));
      const Vector3 place = ((corners[0] - min) + (corners[1] - min) + (corners[2] - min)) / 3 / side;
      keys[t] = {morton_code(place), static_cast<int>(t)};
    }
  });
  sort(keys, threads);
  return keys;
}

// Ericson, Real-Time Collision Detection, 5.1.5. Of a triangle without area the answer is that of one of its edges or
// corners, which may not be the nearest: its longest edge is then another triangle's too.
double squared_distance(const Vector3& p, const Triangle3& t) {
  const Vector3 ab = t[1] - t[0], ac = t[2] - t[0], ap = p - t[0], bp = p - t[1], cp = p - t[2];
  const double d1 = ab.dot(ap), d2 = ac.dot(ap), d3 = ab.dot(bp), d4 = ac.dot(bp), d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d1 <= 0 && d2 <= 0) return ap.squaredNorm();
  if (d3 >= 0 && d4 <= d3) return bp.squaredNorm();
  if (d6 >= 0 && d5 <= d6) return cp.squaredNorm();
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return (ap - d1 / (d1 - d3) * ab).squaredNorm();
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return (ap - d2 / (d2 - d6) * ac).squaredNorm();
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 >= d3 && d5 >= d6) return (bp - (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (t[2] - t[1])).squaredNorm();
  const Vector3 normal = ab.cross(ac);
  const double height = normal.dot(ap);
  return height * height / normal.squaredNorm();
}

struct PointQuery {
  const Vector3& point;
  const std::vector<Triangle3>& triangles;
  double squared;
  int place;

  double bound(const Vector3& box_min, const Vector3& box_max) const {
    return (box_min - point).cwiseMax(point - box_max).cwiseMax(0.0).squaredNorm();
  }
  void meet(std::size_t t) {
    const double distance = squared_distance(point, triangles[t]);
    if (distance < squared) {
      squared = distance;
      place = static_cast<int>(t);
    }
  }
};

// Bounds from below by the gap along the axes and along those normals that the triangle has: its own and, in its plane,
// those of its edges.
struct TriangleQuery {
  TriangleQuery(const Triangle3& asked, const std::vector<Triangle3>& all, double bound)
      : triangle(asked), triangles(all), squared(bound * bound) {
    min = asked[0].cwiseMin(asked[1]).cwiseMin(asked[2]);
    max = asked[0].cwiseMax(asked[1]).cwiseMax(asked[2]);
    const Vector3 normal = (asked[1] - asked[0]).cross(asked[2] - asked[0]).stableNormalized();
    for (std::size_t i = 0; i < 3; ++i) add((asked[(i + 1) % 3] - asked[i]).cross(normal).stableNormalized());
    add(normal);
    add(-normal);
  }
  void add(const Vector3& direction) {
    offsets[count] = std::max({direction.dot(triangle[0]), direction.dot(triangle[1]), direction.dot(triangle[2])});
    directions[count++] = direction;
  }
  double bound(const Vector3& box_min, const Vector3& box_max) const {
    double least = (box_min - max).cwiseMax(min - box_max).cwiseMax(0.0).squaredNorm();
    const Vector3 center = (box_min + box_max) / 2, half = (box_max - box_min) / 2;
    for (std::size_t i = 0; i < count; ++i) {
      const double gap = directions[i].dot(center) - directions[i].cwiseAbs().dot(half) - offsets[i];
      if (gap > 0) least = std::max(least, gap * gap);
    }
    return least;
  }
  void meet(std::size_t t) {
    const double distance = triangle_distance(triangle, triangles[t]);
    squared = std::min(squared, distance * distance);
  }

  const Triangle3& triangle;
  const std::vector<Triangle3>& triangles;
  double squared;
  Vector3 min, max;
  std::array<Vector3, 5> directions;
  std::array<double, 5> offsets{};
  std::size_t count = 0;
};

}  // namespace

SurfaceTree::SurfaceTree(const IndexedMesh& mesh, unsigned threads) {
  const std::vector<Keyed> keys = along_curve(mesh, threads);
  triangles_.resize(keys.size());
  levels_.emplace_back((keys.size() + fan - 1) / fan);
  for_blocks(levels_[0].size(), threads, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      Box box{Vector3::Constant(std::numeric_limits<double>::infinity()),
              Vector3::Constant(-std::numeric_limits<double>::infinity())};
      for (std::size_t k = i * fan; k < std::min(keys.size(), (i + 1) * fan); ++k) {
        triangles_[k] = triangle_of(mesh, keys[k].triangle);
        for (const Vector3& corner : triangles_[k]) {
          box.min = box.min.cwiseMin(corner);
          box.max = box.max.cwiseMax(corner);
        }
      }
      levels_[0][i] = box;
    }
  });
  while (levels_.back().size() > 1) {
    const std::vector<Box>& below = levels_.back();
    std::vector<Box> level((below.size() + fan - 1) / fan);
    for (std::size_t i = 0; i < level.size(); ++i) {
      level[i] = below[i * fan];
      for (std::size_t k = i * fan + 1; k < std::min(below.size(), (i + 1) * fan); ++k) {
        level[i].min = level[i].min.cwiseMin(below[k].min);
        level[i].max = level[i].max.cwiseMax(below[k].max);
      }
    }
    levels_.push_back(std::move(level));
  }
}

template <class Query>
void SurfaceTree::visit(std::size_t level, std::size_t index, Query& query) const {
  const std::size_t first = index * fan;
  if (level == 0) {
    for (std::size_t t = first; t < std::min(triangles_.size(), first + fan); ++t) {
      const auto& [a, b, c] = triangles_[t];
      if (query.bound(a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c)) < query.squared) query.meet(t);
    }
    return;
  }
  const std::vector<Box>& below = levels_[level - 1];
  std::array<std::pair<double, std::size_t>, fan> nearest;
  std::size_t count = 0;
  for (std::size_t k = first; k < std::min(below.size(), first + fan); ++k) {
    const double bound = query.bound(below[k].min, below[k].max);
    if (bound >= query.squared) continue;
    std::size_t at = count++;
    for (; at > 0 && nearest[at - 1].first > bound; --at) nearest[at] = nearest[at - 1];
    nearest[at] = {bound, k};
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (nearest[i].first >= query.squared) return;
    visit(level - 1, nearest[i].second, query);
  }
}

SurfaceTree::Nearest SurfaceTree::nearest(const Vector3& point, int hint) const {
  PointQuery query{point, triangles_, squared_distance(point, triangles_[static_cast<std::size_t>(hint)]), hint};
  visit(levels_.size() - 1, 0, query);
  return {std::sqrt(query.squared), query.place};
}

double SurfaceTree::distance(const Triangle3& triangle, double bound) const {
  TriangleQuery query(triangle, triangles_, bound);
  visit(levels_.size() - 1, 0, query);
  return std::min(bound, std::sqrt(query.squared));
}

}  // namespace cagewright
