// SPDX-License-Identifier: BSD-3-Clause
#include "testdata/generate/figures.h"

namespace cagewright::testdata {
namespace {

void add_trunk_and_head(Field& body) {
  body.add_ellipsoid({0, 0.86, 0}, {0.215, 0.165, 0.150}, 0);
  body.add_ellipsoid({0, 1.08, 0.005}, {0.150, 0.220, 0.120}, 0.12);
  body.add_ellipsoid({0, 1.34, 0}, {0.205, 0.190, 0.145}, 0.12);
  body.add_limb({{{0, 1.46, 0}, 0.090}, {{0.010, 1.58, 0.010}, 0.066}, {{0.020, 1.68, 0.020}, 0.066}}, 0.07);
  body.add_ellipsoid({0.030, 1.80, 0.025}, {0.125, 0.150, 0.140}, 0.06, facing({0.2, -0.1, 1}));
}

// Each arm leaves the shoulder and comes back to the hip: a ring.
void add_arms(Field& body) {
  body.add_limb({{{0.140, 1.430, 0.000}, 0.085},
                 {{0.270, 1.400, -0.010}, 0.074},
                 {{0.410, 1.300, -0.030}, 0.064},
                 {{0.510, 1.150, -0.030}, 0.060},
                 {{0.430, 1.020, -0.010}, 0.058},
                 {{0.310, 0.930, 0.015}, 0.054},
                 {{0.150, 0.880, 0.020}, 0.062}},
                0.06);
  body.add_limb({{{-0.140, 1.430, 0.000}, 0.085},
                 {{-0.265, 1.410, -0.005}, 0.074},
                 {{-0.400, 1.330, -0.010}, 0.064},
                 {{-0.500, 1.185, 0.010}, 0.060},
                 {{-0.440, 1.040, 0.030}, 0.058},
                 {{-0.320, 0.940, 0.030}, 0.054},
                 {{-0.150, 0.885, 0.025}, 0.062}},
                0.06);
}

// Hip, knee, a tight bend, the base, and up the other leg: the third ring.
void add_legs_and_base(Field& body) {
  body.add_limb({{{0.110, 0.830, 0.000}, 0.120},
                 {{0.175, 0.640, 0.010}, 0.102},
                 {{0.220, 0.420, 0.025}, 0.084},
                 {{0.250, 0.210, 0.010}, 0.080},
                 {{0.225, 0.110, 0.005}, 0.092},
                 {{0.110, 0.085, 0.000}, 0.086},
                 {{0.000, 0.085, 0.000}, 0.084},
                 {{-0.110, 0.085, -0.005}, 0.086},
                 {{-0.220, 0.110, -0.010}, 0.092},
                 {{-0.245, 0.210, -0.015}, 0.080},
                 {{-0.215, 0.420, -0.010}, 0.084},
                 {{-0.170, 0.640, -0.005}, 0.102},
                 {{-0.110, 0.830, 0.000}, 0.120}},
                0.06);
}

}  // namespace

Figure make_genus3() {
  Figure figure{"genus3", 3, 120, {}};
  add_trunk_and_head(figure.field);
  add_arms(figure.field);
  add_legs_and_base(figure.field);
  return figure;
}

}  // namespace cagewright::testdata
