// SPDX-License-Identifier: BSD-3-Clause
#include "core/refine/anchors.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "core/mesh/tolerance.h"
#include "core/parallel/parallel_for.h"

namespace cagewright {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::size_t block_size = 8192;  // fixed, so that the work is cut the same way for any number of threads

}  // namespace

bool still_moves(double signed_distance, double delta, double tolerance) {
  return signed_distance > -delta - tolerance;
}

AnchorFinder::AnchorFinder(const Segmentation& segmentation, const Cage& topology, const RefineOptions& options,
                           double delta_length, double extent)
    : segmentation_(segmentation),
      topology_(topology),
      options_(options),
      delta_(delta_length),
      on_plane_(tolerance::on_plane * extent),
      part_triangles_(segmentation.parts.size()) {
  for (std::size_t t = 0; t < topology.triangle_part.size(); ++t)
    part_triangles_[static_cast<std::size_t>(topology.triangle_part[t])].push_back(static_cast<int>(t));
  for (std::size_t p = 0; p < segmentation.parts.size(); ++p) {
    const std::size_t count = segmentation.parts[p].vertices.size();
    seen_through_.emplace_back(count, Cones::inside);
    for (std::size_t begin = 0; begin < count; begin += block_size)
      blocks_.push_back({p, begin, std::min(begin + block_size, count)});
  }
}

void AnchorFinder::set_planes(const Points& points) {
  const Eigen::Index count = topology_.triangles.rows();
  normals_.resize(count, 3);
  barycenters_.resize(count, 3);
  for (Eigen::Index t = 0; t < count; ++t) {
    const auto corners = topology_.triangles.row(t);
    const Vector3 a = points.row(corners(0)), b = points.row(corners(1)), c = points.row(corners(2));
    normals_.row(t) = (b - a).cross(c - a).stableNormalized().transpose();
    barycenters_.row(t) = (a + b + c).transpose() / 3;
  }
}

double AnchorFinder::distance(long vertex, int triangle) const {
  return (segmentation_.cut.points.row(vertex) - barycenters_.row(triangle)).dot(normals_.row(triangle));
}

// Keeps the farther of two vertices; of equally far ones the first, so that neither the order of blocks nor rounding
// matters.
void AnchorFinder::offer(long vertex, int triangle, std::vector<Farthest>& best) const {
  const double d = distance(vertex, triangle);
  Farthest& farthest = best[static_cast<std::size_t>(triangle)];
  if (d > farthest.distance + on_plane_) farthest = {d, vertex};
}

void AnchorFinder::search_local(const Cones& cones, const Block& block, std::vector<Farthest>& best) {
  const std::vector<int>& vertices = segmentation_.parts[block.part].vertices;
  const int part = static_cast<int>(block.part);
  for (std::size_t i = block.begin; i < block.end; ++i) {
    const Vector3 v = segmentation_.cut.points.row(vertices[i]);
    int& triangle = seen_through_[block.part][i];
    if (triangle == Cones::inside || !cones.sees(part, triangle, v)) triangle = cones.triangle_of(part, v);
    if (triangle != Cones::inside) offer(vertices[i], triangle, best);
  }
}

// A component that lies inside others is bounded where any part's cage bounds it; a vertex that none does is left to
// the triangle that it stands out of least.
void AnchorFinder::search_enclosed(const Cones& cones, const Block& block, std::vector<Farthest>& best) const {
  const std::vector<int>& vertices = segmentation_.parts[block.part].vertices;
  for (std::size_t i = block.begin; i < block.end; ++i) {
    const Vector3 v = segmentation_.cut.points.row(vertices[i]);
    int nearest = Cones::inside;
    double least = infinity;
    for (std::size_t p = 0; p < segmentation_.parts.size() && least > 0; ++p) {
      if (segmentation_.parts[p].enclosed) continue;
      const int triangle = cones.triangle_of(static_cast<int>(p), v);
      const double d = triangle == Cones::inside ? -infinity : distance(vertices[i], triangle);
      if (d >= least - on_plane_) continue;
      least = d;
      nearest = triangle;
    }
    if (nearest != Cones::inside) offer(vertices[i], nearest, best);
  }
}

void AnchorFinder::search_part(const Block& block, std::vector<Farthest>& best) const {
  const std::vector<int>& vertices = segmentation_.parts[block.part].vertices;
  for (std::size_t i = block.begin; i < block.end; ++i)
    for (const int triangle : part_triangles_[block.part]) offer(vertices[i], triangle, best);
}

void AnchorFinder::find(const Points& points, RefineRecord& record) {
  set_planes(points);
  const auto count = static_cast<std::size_t>(topology_.triangles.rows());
  const Cones cones(segmentation_, topology_, points, on_plane_);
  std::vector<std::vector<Farthest>> found(blocks_.size());
  parallel_for(blocks_.size(), options_.threads, [&](std::size_t b) {
    found[b].assign(count, {-infinity, -1});
    if (segmentation_.parts[blocks_[b].part].enclosed)
      search_enclosed(cones, blocks_[b], found[b]);
    else if (options_.scope == RefineScope::local)
      search_local(cones, blocks_[b], found[b]);
    else
      search_part(blocks_[b], found[b]);
  });

  record.normals = normals_;
  record.signed_distance.assign(count, -infinity);  // (6)
  record.outermost.assign(count, -1);
  for (const std::vector<Farthest>& of_block : found)
    for (std::size_t t = 0; t < count; ++t) {
      if (of_block[t].distance <= record.signed_distance[t] + on_plane_) continue;
      record.signed_distance[t] = of_block[t].distance;
      record.outermost[t] = of_block[t].vertex;
    }
  record.max_signed_distance =
      count == 0 ? -infinity : *std::max_element(record.signed_distance.begin(), record.signed_distance.end());

  record.anchors = barycenters_;  // (7b)
  for (std::size_t t = 0; t < count; ++t) {
    if (!still_moves(record.signed_distance[t], delta_, on_plane_)) continue;
    const auto row = static_cast<Eigen::Index>(t);  // (7a)
    record.anchors.row(row) = segmentation_.cut.points.row(record.outermost[t]) + delta_ * normals_.row(row);
  }
}

}  // namespace cagewright
