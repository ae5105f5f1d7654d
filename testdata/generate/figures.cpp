// SPDX-License-Identifier: BSD-3-Clause
#include "testdata/generate/figures.h"

namespace cagewright::testdata {

std::vector<Figure> all_figures() {
  return {make_biped(), make_quadruped(), make_octopus(), make_genus3(), make_blob(), make_legs()};
}

}  // namespace cagewright::testdata
