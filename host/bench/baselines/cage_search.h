// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "host/bench/baselines/judge.h"

namespace cagewright::bench {

// A cage that a search found, and how: what it would take a user who knew the parameters from the start.
struct FoundCage {
  Surface cage;
  bool encloses = false;
  double volume_ratio = 0;
  std::string parameters;  // for people: "alpha diagonal/9.3, offset diagonal/200"
  double seconds = 0;      // to make this one
};

// The best so far of what a search tries: enclosing before not, then the smaller volume ratio. Where none encloses, the
// largest ratio, as that one misses least.
class BestCage {
 public:
  explicit BestCage(const Judge& judge, std::size_t most_triangles);

  // Rounds the cage to floats and judges it; one of more than `most_triangles` triangles, or without any, is not taken.
  // Returns whether it encloses.
  bool offer(Surface cage, const std::string& parameters, double seconds);

  std::size_t tried() const { return tried_; }
  const std::optional<FoundCage>& best() const { return best_; }

 private:
  const Judge& judge_;
  std::size_t most_triangles_;
  std::size_t tried_ = 0;
  std::optional<FoundCage> best_;
};

// CGAL's alpha wrap (Portaneri et al. 2022) with that many triangles or fewer: offsets of the diagonal over 20 to 800,
// and for each the smallest alpha that keeps to the number.
void search_alpha_wraps(BestCage& best, const Judge& judge, std::size_t most_triangles);

// Offset and decimated (Deng et al. 2011; Sander et al. 2000): a fine surface at a distance, simplified by edge
// collapses (Lindstrom-Turk, and quadrics by Garland and Heckbert) to that many triangles; the least distance whose
// simplified surface encloses.
void search_decimated_offsets(BestCage& best, const Judge& judge, std::size_t most_triangles);

// Voxel grid (Ben-Chen et al. 2009): the boundary of all cells that hold some of the model, made manifold by
// adding cells; as it is with that many triangles, and finer, grown by 0 to 2 cells and simplified to that many.
void search_voxel_grids(BestCage& best, const Judge& judge, std::size_t most_triangles);

}  // namespace cagewright::bench
