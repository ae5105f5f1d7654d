// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/refine/cones.h"
#include "core/refine/refine.h"

namespace cagewright {

// The condition of (7a): the outermost vertex at `signed_distance` is outside the cage or less than delta inside it. A
// vertex that is at delta up to `tolerance`, as a cap's highest one is from the start, counts, whatever rounding says.
bool still_moves(double signed_distance, double delta, double tolerance);

// Equations (6) and (7) for a cage that moves. Keeps, between calls, which triangle each model vertex was seen through.
class AnchorFinder {
 public:
  // delta_length and extent in model units. What is passed in by reference must outlive the finder.
  AnchorFinder(const Segmentation& segmentation, const Cage& topology, const RefineOptions& options,
               double delta_length, double extent);

  // Fills normals, anchors, signed_distance, outermost and max_signed_distance of `record` for a cage at `points`
  // (n x 3, as Cage::points). The same bits for any number of threads. O(model vertices) when little moved since the
  // last call, at most O(model vertices * triangles of a part).
  void find(const Points& points, RefineRecord& record);

 private:
  struct Block {  // a run of one part's vertices: the unit of parallel work
    std::size_t part, begin, end;
  };
  struct Farthest {
    double distance;
    long vertex;
  };

  void search_local(const Cones& cones, const Block& block, std::vector<Farthest>& best);
  void search_enclosed(const Cones& cones, const Block& block, std::vector<Farthest>& best) const;
  void search_part(const Block& block, std::vector<Farthest>& best) const;
  void set_planes(const Points& points);
  double distance(long vertex, int triangle) const;
  void offer(long vertex, int triangle, std::vector<Farthest>& best) const;

  const Segmentation& segmentation_;
  const Cage& topology_;
  const RefineOptions& options_;
  double delta_, on_plane_;  // model units
  std::vector<std::vector<int>> part_triangles_;
  std::vector<std::vector<int>> seen_through_;  // by part, of each of its vertices: cage triangle or Cones::inside
  std::vector<Block> blocks_;
  Points normals_, barycenters_;  // of the cage's triangles at the current call
};

}  // namespace cagewright
