// SPDX-License-Identifier: BSD-3-Clause
#include "core/refine/anchors.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "core/mesh/tolerance.h"
#include "core/parallel/parallel_for.h"

namespace cagewright {
namespace {

constexpr int inside = -1;  // seen through a section and in front of it: no wall bounds this vertex
constexpr int unknown = -2;
constexpr std::size_t block_size = 8192;  // fixed, so that the work is cut the same way for any number of threads

Vector3 row(const Points& points, Eigen::Index i) { return points.row(i); }

}  // namespace

bool still_moves(double signed_distance, double delta, double tolerance) {
  return signed_distance > -delta - tolerance;
}

// The cones from a part's centre over its cage triangles and its sections, at one position of the cage.
class AnchorFinder::Cones {
 public:
  Cones(const AnchorFinder& finder, const Part& part, const Points& points)
      : on_plane_(finder.on_plane_), center_(finder.topology_.part_center[part.index]) {
    for (int t : part.triangles) {
      const auto corners = finder.topology_.triangles.row(t);
      std::array<Vector3, 3> planes;
      for (int i = 0; i < 3; ++i)
        planes[static_cast<std::size_t>(i)] = plane(row(points, corners(i)), row(points, corners((i + 1) % 3)));
      walls_.push_back(planes);
    }
    for (const PartSection& side : finder.segmentation_.parts[part.index].sections) {
      Opening opening;
      const SectionFrame& section = finder.sections_[static_cast<std::size_t>(side.slide)];
      opening.outward = side.outward ? section.normal : Vector3(-section.normal);
      opening.on_plane = section.center;
      for (int i = 0; i < 4; ++i) {
        const int from = side.outward ? i : (4 - i) % 4, to = side.outward ? (i + 1) % 4 : 3 - i;
        opening.planes[static_cast<std::size_t>(i)] =
            plane(row(points, 4 * side.slide + from), row(points, 4 * side.slide + to));
      }
      openings_.push_back(opening);
    }
  }

  bool sees(int wall, const Vector3& v) const {
    return wall >= 0 && margin(walls_[static_cast<std::size_t>(wall)], v - center_) >= 0;
  }

  // The wall through which v is seen, or `inside`. Where the cage folds or v lies behind a section: the nearest cone.
  int wall_of(const Vector3& v) const {
    const Vector3 ray = v - center_;
    int nearest = inside;
    double best = -std::numeric_limits<double>::infinity();
    for (std::size_t w = 0; w < walls_.size(); ++w) {
      const double m = margin(walls_[w], ray);
      if (m >= 0) return static_cast<int>(w);
      if (m <= best) continue;
      best = m;
      nearest = static_cast<int>(w);
    }
    return in_front_of_a_section(v) ? inside : nearest;
  }

  bool in_front_of_a_section(const Vector3& v) const {
    const Vector3 ray = v - center_;
    return std::any_of(openings_.begin(), openings_.end(), [&](const Opening& o) {
      return margin(o.planes, ray) >= 0 && o.outward.dot(v - o.on_plane) <= on_plane_;
    });
  }

 private:
  struct Opening {
    std::array<Vector3, 4> planes;
    Vector3 outward, on_plane;
  };

  // Through the centre and the edge from a to b; positive on the left as seen from outside.
  Vector3 plane(const Vector3& a, const Vector3& b) const {
    return (a - center_).cross(b - center_).stableNormalized();
  }

  template <std::size_t n>
  static double margin(const std::array<Vector3, n>& planes, const Vector3& ray) {
    double least = planes[0].dot(ray);
    for (std::size_t i = 1; i < n; ++i) least = std::min(least, planes[i].dot(ray));
    return least;
  }

  double on_plane_;
  Vector3 center_;
  std::vector<std::array<Vector3, 3>> walls_;
  std::vector<Opening> openings_;
};

AnchorFinder::AnchorFinder(const Segmentation& segmentation, const std::vector<SectionFrame>& sections,
                           const Cage& topology, const RefineOptions& options, double diagonal)
    : segmentation_(segmentation),
      sections_(sections),
      topology_(topology),
      options_(options),
      delta_(options.delta * diagonal),
      on_plane_(tolerance::on_plane * diagonal) {
  std::vector<int> slot(segmentation.parts.size(), -1);
  for (std::size_t p = 0; p < segmentation.parts.size(); ++p) {
    if (segmentation.parts[p].enclosed) continue;
    slot[p] = static_cast<int>(parts_.size());
    parts_.push_back({p, {}, std::vector<int>(segmentation.parts[p].vertices.size(), unknown)});
  }
  for (std::size_t t = 0; t < topology.triangle_part.size(); ++t)
    parts_[static_cast<std::size_t>(slot[static_cast<std::size_t>(topology.triangle_part[t])])].triangles.push_back(
        static_cast<int>(t));
  for (std::size_t p = 0; p < parts_.size(); ++p)
    for (std::size_t begin = 0; begin < parts_[p].seen_through.size(); begin += block_size)
      blocks_.push_back({p, begin, std::min(begin + block_size, parts_[p].seen_through.size())});
}

double AnchorFinder::distance(long vertex, int triangle) const {
  return (row(segmentation_.cut.points, vertex) - row(barycenters_, triangle)).dot(row(normals_, triangle));
}

void AnchorFinder::search_local(const Points& points, const Block& block, std::vector<Farthest>& best) {
  Part& part = parts_[block.part];
  const Cones cones(*this, part, points);
  const std::vector<int>& vertices = segmentation_.parts[part.index].vertices;
  for (std::size_t i = block.begin; i < block.end; ++i) {
    const Vector3 v = row(segmentation_.cut.points, vertices[i]);
    int& wall = part.seen_through[i];
    if (!cones.sees(wall, v)) wall = cones.wall_of(v);
    if (wall == inside) continue;
    Farthest& farthest = best[static_cast<std::size_t>(wall)];
    const double d = distance(vertices[i], part.triangles[static_cast<std::size_t>(wall)]);
    if (d > farthest.distance) farthest = {d, vertices[i]};
  }
}

void AnchorFinder::search_part(const Points&, const Block& block, std::vector<Farthest>& best) const {
  const Part& part = parts_[block.part];
  const std::vector<int>& vertices = segmentation_.parts[part.index].vertices;
  for (std::size_t i = block.begin; i < block.end; ++i)
    for (std::size_t w = 0; w < part.triangles.size(); ++w) {
      const double d = distance(vertices[i], part.triangles[w]);
      if (d > best[w].distance) best[w] = {d, vertices[i]};
    }
}

void AnchorFinder::set_normals(const Points& points, RefineRecord& record) const {
  const Eigen::Index count = topology_.triangles.rows();
  record.normals.resize(count, 3);
  for (Eigen::Index t = 0; t < count; ++t) {
    const auto corners = topology_.triangles.row(t);
    const Vector3 a = row(points, corners(0)), b = row(points, corners(1)), c = row(points, corners(2));
    record.normals.row(t) = (b - a).cross(c - a).stableNormalized().transpose();
  }
}

void AnchorFinder::find(const Points& points, RefineRecord& record) {
  set_normals(points, record);
  normals_ = record.normals;
  const Eigen::Index count = topology_.triangles.rows();
  barycenters_.resize(count, 3);
  for (Eigen::Index t = 0; t < count; ++t) {
    const auto corners = topology_.triangles.row(t);
    barycenters_.row(t) = (points.row(corners(0)) + points.row(corners(1)) + points.row(corners(2))) / 3;
  }
  const double none = -std::numeric_limits<double>::infinity();
  std::vector<std::vector<Farthest>> found(blocks_.size());
  parallel_for(blocks_.size(), options_.threads, [&](std::size_t b) {
    found[b].assign(parts_[blocks_[b].part].triangles.size(), {none, -1});
    if (options_.scope == RefineScope::local)
      search_local(points, blocks_[b], found[b]);
    else
      search_part(points, blocks_[b], found[b]);
  });

  record.signed_distance.assign(static_cast<std::size_t>(count), none);  // (6)
  record.outermost.assign(static_cast<std::size_t>(count), -1);
  record.max_signed_distance = none;
  for (std::size_t b = 0; b < blocks_.size(); ++b)
    for (std::size_t w = 0; w < found[b].size(); ++w) {
      const auto t = static_cast<std::size_t>(parts_[blocks_[b].part].triangles[w]);
      if (found[b][w].distance <= record.signed_distance[t]) continue;
      record.signed_distance[t] = found[b][w].distance;
      record.outermost[t] = found[b][w].vertex;
      record.max_signed_distance = std::max(record.max_signed_distance, found[b][w].distance);
    }

  record.anchors = barycenters_;  // (7b)
  for (Eigen::Index t = 0; t < count; ++t) {
    const auto i = static_cast<std::size_t>(t);
    if (still_moves(record.signed_distance[i], delta_, on_plane_))  // (7a)
      record.anchors.row(t) = segmentation_.cut.points.row(record.outermost[i]) + delta_ * record.normals.row(t);
  }
}

}  // namespace cagewright
