// SPDX-License-Identifier: BSD-3-Clause
#include "core/measure/measure_cage.h"

#include <cmath>

#include "core/error/error.h"

namespace cagewright {

CageMeasures measure_cage(const IndexedMesh& model, const IndexedMesh& cage, const Certificate& certificate,
                          unsigned threads) {
  if (!(std::abs(signed_volume(model)) > 0)) {
    throw Error(ErrorCode::mesh_empty, "the model encloses no volume, so that no cage can be measured against it");
  }
  const MeasuredModel measured(model, threads);
  return {measure_tightness(measured, cage, certificate, threads), measure_shape(cage),
          measure_asymmetry(measured, find_mirror_planes(measured, threads), cage, threads)};
}

}  // namespace cagewright
