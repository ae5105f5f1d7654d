// SPDX-License-Identifier: BSD-3-Clause
#include "testdata/generate/figures.h"

namespace cagewright::testdata {

// Each leg is thick where the other one is thin, so that neither one's cage has room for straight walls.
Figure make_legs() {
  constexpr double melt = 0.02;  // less than twice the gap between the legs, or they would run together
  Figure figure{"legs", 0, 120, {}};
  figure.field.add_ellipsoid({0.004, 1.12, 0}, {0.33, 0.21, 0.21}, 0);
  figure.field.add_limb({{{0.150, 1.06, 0.000}, 0.130},
                         {{0.128, 0.80, 0.006}, 0.076},
                         {{0.106, 0.58, 0.010}, 0.118},
                         {{0.128, 0.34, 0.004}, 0.072},
                         {{0.112, 0.10, 0.000}, 0.098}},
                        melt);
  figure.field.add_limb({{{-0.150, 1.06, 0.004}, 0.130},
                         {{-0.105, 0.82, 0.010}, 0.100},
                         {{-0.131, 0.57, 0.006}, 0.070},
                         {{-0.103, 0.335, 0.002}, 0.112},
                         {{-0.130, 0.10, 0.008}, 0.070}},
                        melt);
  return figure;
}

}  // namespace cagewright::testdata
