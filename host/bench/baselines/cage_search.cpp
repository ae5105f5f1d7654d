// SPDX-License-Identifier: BSD-3-Clause
#include "host/bench/baselines/cage_search.h"

#include <utility>

namespace cagewright::bench {

BestCage::BestCage(const Judge& judge, std::size_t most_triangles) : judge_(judge), most_triangles_(most_triangles) {}

bool BestCage::offer(Surface cage, const std::string& parameters, double seconds) {
  ++tried_;
  if (cage.is_empty() || triangle_count(cage) > most_triangles_) return false;
  round_to_floats(cage);
  const bool encloses = judge_.encloses(cage);
  const double ratio = judge_.volume_ratio(cage);
  const bool better = !best_ || (encloses != best_->encloses ? encloses
                                 : encloses                  ? ratio < best_->volume_ratio
                                                             : ratio > best_->volume_ratio);
  if (better) best_ = FoundCage{std::move(cage), encloses, ratio, parameters, seconds};
  return encloses;
}

}  // namespace cagewright::bench
